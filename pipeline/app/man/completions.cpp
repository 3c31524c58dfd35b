// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "pipeline/app/man/man.hpp"

namespace ashimpact {

namespace {

/// What to call for a value.
std::string bash_action(const Values& values) {
    switch (values.kind) {
        case Values::Kind::words:
            return fmt::format("_ashimpact_words '{}'", fmt::join(values.words, " "));
        case Values::Kind::quantity:
            return fmt::format("_ashimpact_quantity '{}'", fmt::join(values.words, "' '"));
        case Values::Kind::file:
            return fmt::format("_ashimpact_files '{}'", values.extension);
        case Values::Kind::folder:
            return "_ashimpact_folders";
        case Values::Kind::text:
        case Values::Kind::none:
            break;
    }
    return "return";
}

std::string names_of(const CommandEntry& command) {
    std::string names;
    for (const OptionEntry& option : command.options) {
        for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
    }
    return names;
}

/// The cases of one command: options by the word before, then its options and arguments.
std::string command_case(const CommandEntry& command) {
    std::string text = fmt::format("        {})\n            case $previous in\n", command.name);
    for (const OptionEntry& option : command.options) {
        if (option.values.kind == Values::Kind::none) continue;
        text += fmt::format("                {}) {}; return ;;\n", fmt::join(option.names, " | "),
                            bash_action(option.values));
    }
    text += fmt::format(
        "            esac\n            if [[ $current == -* ]]; then\n                _ashimpact_words "
        "'{}'\n",
        names_of(command));
    if (!command.arguments.empty()) {
        text += fmt::format("            else\n                {}\n",
                            bash_action(command.arguments.front().values));
    }
    return text + "            fi\n            ;;\n";
}

constexpr auto helpers = R"(# Completion of ashimpact for bash; generated from the program's own command line.

_ashimpact_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current"); }

# Folders, and files that end as asked for.
_ashimpact_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X "!*$1" -- "$current")
}

_ashimpact_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$current")
}

# A number that has been typed, with each of the units: "44 <TAB>.
_ashimpact_quantity() {
    local typed=${current#[\"\']} number unit
    [[ $typed =~ ^([0-9.eE+-]+)\ ?([A-Za-z/0-9]*)$ ]] || return
    number=${BASH_REMATCH[1]}
    for unit in "$@"; do
        [[ $unit != "${BASH_REMATCH[2]}"* ]] || COMPREPLY+=("$number $unit")
    done
    compopt -o filenames 2>/dev/null  # puts the blank in quotes
}

_ashimpact() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' word
    COMPREPLY=()
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        [[ $word == -* ]] || { command=$word; break; }
    done
    case $command in
)";

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
std::string zsh_action(const Values& values) {
    std::string words;
    for (const std::string& word : values.words) words += (words.empty() ? "" : " ") + quoted(word);
    switch (values.kind) {
        case Values::Kind::words:
            return "(" + words + ")";
        case Values::Kind::quantity:
            return fmt::format("_ashimpact_quantity \"{}\" ", fmt::join(values.words, "\" \""));
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

std::string specification(const OptionEntry& option) {
    const std::string value = option.values.kind == Values::Kind::none
                                  ? std::string()
                                  : fmt::format(":{}:{}", quoted(option.type), zsh_action(option.values));
    if (option.names.empty())
        return fmt::format(" '{}:{}:{}'", option.required ? "" : ":", quoted(option.type),
                           zsh_action(option.values));
    std::string text;
    for (const std::string& name : option.names) {
        text += fmt::format(" \\\n                '{}{}[{}]{}'", option.repeats ? "*" : "", name,
                            quoted(option.description), value);
    }
    return text;
}

}  // namespace

std::string bash_completion(const ProgramEntry& entry) {
    std::string commands;
    std::string text = helpers;
    for (const CommandEntry& command : entry.commands) {
        text += command_case(command);
        commands += " " + command.name;
    }
    text += fmt::format(
        "        '') _ashimpact_words '{}{}' ;;\n    esac\n}}\n\ncomplete -F _ashimpact ashimpact\n",
        names_of(entry.program), commands);
    return text;
}

std::string zsh_completion(const ProgramEntry& entry) {
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
    for (const CommandEntry& command : entry.commands) {
        text += fmt::format("        '{}:{}'\n", command.name, quoted(command.purpose));
    }
    text += "    )\n    _arguments -C";
    for (const OptionEntry& option : entry.program.options) text += specification(option);
    text +=
        " \\\n                '1:command:->command' '*::argument:->argument'\n"
        "    case $state in\n"
        "        command) _describe command commands ;;\n"
        "        argument)\n            case $line[1] in\n";
    for (const CommandEntry& command : entry.commands) {
        text += fmt::format("            {}) _arguments", command.name);
        for (const OptionEntry& option : command.options) text += specification(option);
        for (const OptionEntry& argument : command.arguments) text += specification(argument);
        text += " ;;\n";
    }
    return text + "            esac ;;\n    esac\n}\n\n_ashimpact \"$@\"\n";
}

}  // namespace ashimpact
