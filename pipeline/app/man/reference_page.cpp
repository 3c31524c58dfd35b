// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "pipeline/app/man/writers.hpp"

namespace ashimpact {

namespace {

/// Text inside a cell of a table.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string row(const OptionPaper& option) {
    std::string name;
    for (const std::string& one : option.names) name += (name.empty() ? "" : ", ") + ("`" + one);
    for (std::size_t at = name.find(", `"); at != std::string::npos; at = name.find(", `", at + 3)) {
        name.insert(at, "`");
        ++at;
    }
    if (name.empty()) {
        name = "`" + option.type + "`";
    } else {
        name += option.type.empty() ? "`" : " " + option.type + "`";
    }
    std::string values;
    if (option.values.kind == Values::Kind::words) {
        for (const std::string& word : option.values.words)
            values += (values.empty() ? " One of " : ", ") + ("`" + word + "`");
        values += ".";
    }
    const std::string fallback =
        option.default_value.empty() ? "" : " Default: `" + option.default_value + "`.";
    return fmt::format("| {} | {}{}.{}{} |\n", name, option.required ? "**required**; " : "",
                       cell(option.description), cell(values), cell(fallback));
}

std::string table(const std::vector<OptionPaper>& options) {
    std::string text = "| option | meaning |\n|---|---|\n";
    for (const OptionPaper& option : options) text += row(option);
    return text + "\n";
}

std::string example_block(const std::string& footer) {
    const std::string word = "Example:\n";
    const std::string lines = footer.starts_with(word) ? footer.substr(word.size()) : footer;
    return "```text\n" + lines + "\n```\n\n";
}

}  // namespace

std::string reference_page(const ProgramPaper& paper) {
    std::string page =
        "# Commands\n\n"
        "This page lists every command with its options. It is written by the program that parses them, as "
        "are the "
        "manual pages and what bash and zsh complete.\n\n"
        "Quantities carry their unit in quotes, `\"44 um\"`; a bare number is SI. Results go to standard "
        "output, "
        "messages to standard error. Exit status: 0 done; 2 the input is wrong; 3 a computation did not "
        "converge; 1 a "
        "defect of the program.\n\n";
    for (const CommandPaper& command : paper.commands) {
        page += fmt::format("## ashimpact {}\n\n{}.\n\n", command.name, command.purpose);
        if (!command.arguments.empty()) page += table(command.arguments);
        page += table(command.options) + example_block(command.example);
    }
    return page;
}

}  // namespace ashimpact
