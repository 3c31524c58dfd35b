// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "pipeline/app/man/writers.hpp"

namespace ashimpact {

namespace {

/// Text inside a specification of _arguments in single quotes.
std::string quoted(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else if (c == '\n') {
            result += ' ';
        } else {
            if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result;
}

/// What completes a value.
std::string action_of(const Values& values) {
    std::string words;
    for (const std::string& word : values.words) words += (words.empty() ? "" : " ") + quoted(word);
    switch (values.kind) {
        case Values::Kind::words:
            return "(" + words + ")";
        case Values::Kind::quantity:
            return "_ashimpact_quantity " + [&values] {
                std::string units;
                for (const std::string& unit : values.words) {
                    units += "\"" + unit + "\" ";
                }
                return units;
            }();
        case Values::Kind::file:
            return values.extension.empty() ? "_files" : "_files -g \"*" + values.extension + "(-.)\"";
        case Values::Kind::folder:
            return "_files -/";
        case Values::Kind::text:
        case Values::Kind::none:
            break;
    }
    return " ";
}

std::string specification(const OptionPaper& option) {
    const std::string value = option.values.kind == Values::Kind::none
                                  ? std::string()
                                  : fmt::format(":{}:{}", quoted(option.type), action_of(option.values));
    if (option.names.empty())
        return fmt::format(" '{}:{}:{}'", option.required ? "" : ":", quoted(option.type),
                           action_of(option.values));
    std::string text;
    for (const std::string& name : option.names) {
        text += fmt::format(" \\\n                '{}{}[{}]{}'", option.repeats ? "*" : "", name,
                            quoted(option.description), value);
    }
    return text;
}

}  // namespace

std::string zsh_completion(const ProgramPaper& paper) {
    std::string text = R"(#compdef ashimpact
# Completion of ashimpact for zsh; generated from the program's own command line.

# A number that has been typed, with each of the units.
_ashimpact_quantity() {
    local typed=${(Q)PREFIX} number
    number=${typed%%[^0-9.eE+-]*}
    [[ -n $number ]] || { _message 'a number and its unit, in quotes'; return }
    local -a offers
    local unit
    for unit in "$@"; do offers+=("$number $unit"); done
    compadd -U -- $offers
}

_ashimpact() {
    local -a commands
    local context state state_descr line
    typeset -A opt_args
    commands=(
)";
    for (const CommandPaper& command : paper.commands) {
        text += fmt::format("        '{}:{}'\n", command.name, quoted(command.purpose));
    }
    text += "    )\n    _arguments -C";
    for (const OptionPaper& option : paper.program.options) text += specification(option);
    text +=
        " \\\n                '1:command:->command' '*::argument:->argument'\n"
        "    case $state in\n"
        "        command) _describe command commands ;;\n"
        "        argument)\n            case $line[1] in\n";
    for (const CommandPaper& command : paper.commands) {
        text += fmt::format("            {}) _arguments", command.name);
        for (const OptionPaper& option : command.options) text += specification(option);
        for (const OptionPaper& argument : command.arguments) text += specification(argument);
        text += " ;;\n";
    }
    return text + "            esac ;;\n    esac\n}\n\n_ashimpact \"$@\"\n";
}

}  // namespace ashimpact
