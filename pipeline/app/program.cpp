// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/program.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/terminal/help.hpp"
#include "pipeline/app/terminal/messages.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

namespace {

enum ExitStatus : int { done = 0, defect = 1, wrong_input = 2, not_converged = 3 };

std::shared_ptr<Messages> set_up_messages() {
    auto messages = std::make_shared<Messages>();
    auto logger = std::make_shared<spdlog::logger>("ashimpact", messages);
    logger->set_pattern("%v");
    spdlog::set_default_logger(std::move(logger));
    return messages;
}

/// Prints a text and checks that it arrived.
void print(const std::string& text) {
    const std::string shown = without_controls(text);
    std::cout << (is_colored(STDOUT_FILENO) ? with_colors(shown) : shown) << std::flush;
    if (!std::cout) throw InputError("cannot be written", "a place with room").at("standard output");
}

/// Whether a line is a command to be typed, as those that say what to do next are.
bool is_command(const std::string& line) {
    static const std::vector<std::string> beginnings{"  " + program_word() + ' ', "  sh ", "  python3 "};
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const std::string& beginning) { return line.starts_with(beginning); });
}

/// The lines of a text no longer than the output is wide, and commands such that they can be typed as they
/// stand; JSON, which is for programs, as it is.
std::string laid_out(const std::string& text) {
    if (text.starts_with('{') || text.starts_with('[')) return text;
    const std::size_t width = output_width();
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); out += '\n')
        out += is_command(line) ? wrapped_command(line, width) : wrapped(line, width, 2);
    return out;
}

/// Prints the result. If the output files are already written, a failure to print is only a warning.
void print_result(const std::string& text, bool writes_files) {
    try {
        print(laid_out(text));
    } catch (const InputError& error) {
        if (!writes_files) throw;
        spdlog::warn("warning: {}; all files were written", error.what());
    }
}

/// Runs a command, which prints all of its result or nothing.
void perform(const Action& action, bool writes_files, Messages& messages) {
    std::ostringstream out;
    try {
        action(out);
    } catch (const InputError&) {
        messages.drop();  // one line says what is wrong
        throw;
    } catch (const std::filesystem::filesystem_error& error) {  // such as a name that is too long
        messages.drop();
        throw InputError("cannot be used: " + error.code().message(), "a path that the system takes")
            .at(FileName{shortened(error.path1().string())});
    }
    messages.release();
    print_result(out.str(), writes_files);
}

/// Neither quiet and verbose at once, wherever on the line they stand.
void check_common_options(const CLI::App& program) {
    const auto given = [&](const char* name) {
        return program.count(name) > 0 || program.get_subcommands().front()->count(name) > 0;
    };
    if (given("--quiet") && given("--verbose"))
        throw InputError("both are given", "one of the two").at("--quiet, --verbose");
}

/// Help or version. @throws CLI::ExtrasError if it was asked of a command that there is not
void answer(const CLI::App& program, const CLI::Success& request) {
    const auto unknown = program.remaining();
    if (program.get_subcommands().empty() && !unknown.empty()) throw CLI::ExtrasError("ashimpact", unknown);
    std::ostringstream out;
    static_cast<void>(program.exit(request, out, out));
    print(help_layout(out.str(), output_width()));
}

/// Parses the command line and runs its command.
void run_command_line(CLI::App& program, int argc, const char* const* argv, const Action& action,
                      Messages& messages) {
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& request) {  // --help, --version
        answer(program, request);
        return;
    }
    check_common_options(program);
    constexpr std::array<std::string_view, 6> writing{"run", "sweep", "init", "export", "report", "figure"};
    const std::string command = program.get_subcommands().front()->get_name();
    perform(action, std::find(writing.begin(), writing.end(), command) != writing.end(), messages);
}

/// The words of the command line; `help` is `--help`, and `help COMMAND` is `COMMAND --help`.
std::vector<const char*> words_of(int argc, const char* const* argv) {
    std::vector<const char*> words(argv, argv + argc);
    if (words.size() < 2 || std::string_view(words[1]) != "help") return words;
    words.erase(words.begin() + 1);
    words.insert(words.begin() + std::min<std::ptrdiff_t>(2, std::ssize(words)), "--help");
    return words;
}

}  // namespace

int run_program(int argc, const char* const* argv, const SweepRunner& sweep, const ExportRunner& exporter) {
    const auto messages = set_up_messages();
    set_program_word(argc > 0 ? argv[0] : nullptr);
    CLI::App program;
    Action action;
    set_up_commands(program, action, sweep, exporter);
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of its write
    try {
        const auto words = words_of(argc, argv);
        run_command_line(program, static_cast<int>(words.size()), words.data(), action, *messages);
        return done;
    } catch (const CLI::ParseError& error) {
        spdlog::error("{}", usage_error(program, error));
        return wrong_input;
    } catch (const InputError& error) {
        spdlog::error("{}", on_one_line(error.what()));
        return wrong_input;
    } catch (const ConvergenceError& error) {
        messages->release();
        spdlog::error("not converged: {}", on_one_line(error.what()));
        return not_converged;
    } catch (const std::exception& error) {
        spdlog::error("a defect of ashimpact {}: {}", version_text(), on_one_line(error.what()));
        return defect;
    }
}

}  // namespace ashimpact
