// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/terminal/help.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/text/text.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

namespace {

std::string started_by = "ashimpact";  ///< program_word()

constexpr std::string_view command_head = "  ashimpact ";

/// Where the description of an option or a command begins: behind two blanks or more after its name.
std::size_t description_column(const std::string& line) {
    const auto name = line.find_first_not_of(' ');
    if (name == 0 || name == std::string::npos) return 0;
    if (name > 8) return name;  // a description in a line of its own
    const auto end = line.find("  ", name);
    return end == std::string::npos ? name : std::min(line.find_first_not_of(' ', end), line.size());
}

/// As it is typed: --law; a positional one by its type, CASE.json.
std::string name_of_option(const CLI::Option& option) {
    return option.get_positional() ? option.get_type_name() : option.get_name();
}

std::vector<std::string> names_of_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) names.push_back(name_of_option(*option));
    return names;
}

std::string missing(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_required() && option->count() == 0)
            return fmt::format("{} is missing; allowed: {}", name_of_option(*option),
                               option->get_description());
    return "an option is missing; allowed: " + joined(names_of_options(command));
}

/// The name that a word begins, else the nearest one; at most one.
std::vector<std::string> meant(const std::string& word, const std::vector<std::string>& names) {
    constexpr std::size_t shortest = 4;  // two letters after the dashes
    if (word.size() >= shortest)
        for (const std::string& name : names)
            if (name.starts_with(word)) return {name};
    // Without the dashes, which all options share: --plot is not --from.
    const std::size_t dashes = std::min(word.find_first_not_of('-'), word.size());
    std::vector<std::string> bare;
    for (const std::string& name : names)
        if (name.starts_with(std::string(dashes, '-'))) bare.push_back(name.substr(dashes));
    std::vector<std::string> guess = nearest(word.substr(dashes), bare, 1);
    for (std::string& name : guess) name.insert(0, dashes, '-');
    return guess;
}

std::string unexpected(const CLI::App& command) {
    const auto names = names_of_options(command);
    const std::string given = command.remaining().empty() ? "" : command.remaining().front();
    const auto guess = meant(given, names);
    return fmt::format("{} is not expected{}; allowed: {}", in_quotes(given),
                       guess.empty() ? "" : ", did you mean " + guess.front() + "?", joined(names));
}

/// The option that a message of the parser starts with.
const CLI::Option* option_in(const CLI::App& command, const std::string& message) {
    return command.get_option_no_throw(message.substr(0, message.find(':')));
}

std::string wrong_count(const CLI::App& command, const std::string& message) {
    const CLI::Option* option = option_in(command, message);
    if (option == nullptr) return message + "; allowed: one value for each option";
    return fmt::format("{} {}; allowed: {}", name_of_option(*option),
                       option->count() > 1 ? "is given more than once" : "has no value",
                       option->get_description());
}

std::string what_is_wrong(const CLI::App& command, const CLI::Error& error) {
    std::string message = error.what();
    const bool is_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    if (is_missing && command.remaining().empty()) return missing(command);
    if (is_missing) return unexpected(command);  // perhaps the missing one, mistyped
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unexpected(command);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return wrong_count(command, message);
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) return message + "; allowed: one of them";
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr)
        return message + "; allowed: both or neither";
    const CLI::Option* option = option_in(command, message);
    if (option != nullptr && option->get_positional())
        message = option->get_type_name() + message.substr(message.find(':'));
    if (option == nullptr || message.find("; allowed: ") != std::string::npos) return message;
    return message + "; allowed: " + option->get_description();
}

}  // namespace

const std::string& program_word() {
    return started_by;
}

void set_program_word(const char* typed) {
    if (typed != nullptr && *typed != '\0') started_by = shell_word(typed);
}

std::string help_layout(const std::string& help, std::size_t width) {
    std::istringstream lines(help);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(command_head)) {
            out += wrapped_command("  " + program_word() + line.substr(command_head.size() - 1), width);
        } else {
            const std::size_t column = description_column(line);
            const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
            out += wrapped(line, width, column > own && column < width / 2 ? column - own : 0);
        }
        out += '\n';
    }
    return out;
}

std::string usage_error(const CLI::App& program, const CLI::Error& error) {
    const auto chosen = program.get_subcommands();
    if (!chosen.empty()) {
        const std::string command = chosen.front()->get_name();
        return on_one_line(fmt::format("ashimpact {}: {}; see `{} {} --help`", command,
                                       what_is_wrong(*chosen.front(), error), program_word(), command));
    }
    std::vector<std::string> commands;
    for (const CLI::App* each : program.get_subcommands([](const CLI::App*) { return true; }))
        commands.push_back(each->get_name());
    const auto unknown = program.remaining();
    return on_one_line(fmt::format("ashimpact: {}; allowed: {}; see `{} --help`",
                                   unknown.empty() ? "a command is missing"
                                                   : "unknown command " + in_quotes(unknown.front()) +
                                                         did_you_mean(unknown.front(), commands),
                                   joined(commands), program_word()));
}

}  // namespace ashimpact
