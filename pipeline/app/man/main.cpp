// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "pipeline/app/command.hpp"
#include "pipeline/app/man/man.hpp"

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (!out) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

/// ashimpact-papers FOLDER: writes manual pages, completions and the reference page of the command line
/// there.
int main(int argc, char** argv) {
    using namespace ashimpact;
    if (argc != 2) {
        std::cerr << "usage: ashimpact-papers FOLDER\n";
        return 2;
    }
    try {
        CLI::App program;
        Action action;
        set_up_commands(program, action, {}, {});
        const ProgramEntry entry = entry_of(program);
        const std::filesystem::path folder = argv[1];
        write(folder / "man/ashimpact.1", man_page(entry));
        for (const CommandEntry& command : entry.commands) {
            write(folder / ("man/ashimpact-" + command.name + ".1"), man_page(entry, command));
        }
        write(folder / "bash/ashimpact", bash_completion(entry));
        write(folder / "zsh/_ashimpact", zsh_completion(entry));
        write(folder / "reference/commands.md", reference_page(entry));
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "ashimpact-papers: " << error.what() << '\n';
        return 1;
    }
}
