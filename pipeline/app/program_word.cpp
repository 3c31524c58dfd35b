// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/program_word.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "core/text.hpp"

namespace ashimpact {

namespace {

constexpr auto program_name = "ashimpact";

bool is_on_search_path(const std::filesystem::path& program) {
    const char* folders = std::getenv("PATH");
    std::istringstream list(folders == nullptr ? "" : folders);
    for (std::string folder; std::getline(list, folder, ':');) {
        const auto candidate = std::filesystem::path(folder) / program_name;
        std::error_code missing;
        if (std::filesystem::exists(candidate, missing))  // the first one is what a shell takes
            return std::filesystem::equivalent(candidate, program, missing);
    }
    return false;
}

}  // namespace

std::string program_word() {
    std::error_code unknown;
    auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    if (unknown || !program.filename().string().starts_with(program_name)) return program_name;
    program.replace_filename(program_name);  // not the part of it that computes sweeps
    if (!std::filesystem::exists(program, unknown) || is_on_search_path(program)) return program_name;
    const auto folder = std::filesystem::current_path(unknown);
    const auto relative = program.lexically_relative(folder);
    const bool below = !unknown && !relative.empty() && *relative.begin() != "..";
    std::string path = below ? relative.string() : program.string();
    if (path.find('/') == std::string::npos) path.insert(0, "./");
    return shell_word(path);
}

}  // namespace ashimpact
