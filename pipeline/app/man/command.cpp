// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/man/command.hpp"

#include <CLI/CLI.hpp>

namespace ashimpact {

namespace {

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

/// The kind of value without what its checks add to it.
std::string type_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const auto colon = type.find(':');
    return colon == std::string::npos || type.ends_with("]") ? type : type.substr(0, colon);
}

OptionPaper paper_of(const std::string& command, const CLI::Option& option) {
    const bool is_flag = option.get_expected_max() == 0;
    OptionPaper paper{.names = names_of(option),
                      .type = is_flag ? "" : type_of(option),
                      .description = option.get_description(),
                      .default_value = is_flag ? "" : option.get_default_str(),
                      .required = option.get_required(),
                      .repeats = option.get_expected_max() > 1};
    const std::string& name = paper.names.empty() ? option.get_single_name() : paper.names.back();
    if (!is_flag) paper.values = values_of(command, name, paper.type);
    return paper;
}

CommandPaper command_of(const CLI::App& app) {
    CommandPaper paper{.name = app.get_name(), .purpose = app.get_description(), .example = app.get_footer()};
    for (const CLI::Option* option : app.get_options()) {
        OptionPaper one = paper_of(paper.name, *option);
        (one.names.empty() ? paper.arguments : paper.options).push_back(std::move(one));
    }
    return paper;
}

}  // namespace

ProgramPaper paper_of(const CLI::App& program) {
    ProgramPaper paper{.program = command_of(program)};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        paper.commands.push_back(command_of(*command));
    }
    return paper;
}

}  // namespace ashimpact
