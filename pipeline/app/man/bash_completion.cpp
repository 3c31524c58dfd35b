// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "pipeline/app/man/writers.hpp"

namespace ashimpact {

namespace {

std::string joined_words(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
    return line;
}

/// What to call for a value.
std::string action_of(const Values& values) {
    switch (values.kind) {
        case Values::Kind::words:
            return fmt::format("_ashimpact_words '{}'", joined_words(values.words));
        case Values::Kind::quantity: {
            std::string units;
            for (const std::string& unit : values.words) units += " '" + unit + "'";
            return "_ashimpact_quantity" + units;
        }
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

std::string names_of(const CommandPaper& command) {
    std::string names;
    for (const OptionPaper& option : command.options) {
        for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
    }
    return names;
}

/// The cases of one command: options by the word before, then its options and arguments.
std::string command_case(const CommandPaper& command) {
    std::string text = fmt::format("        {})\n            case $previous in\n", command.name);
    for (const OptionPaper& option : command.options) {
        if (option.values.kind == Values::Kind::none) continue;
        std::string pattern;
        for (const std::string& name : option.names) pattern += (pattern.empty() ? "" : " | ") + name;
        text += fmt::format("                {}) {}; return ;;\n", pattern, action_of(option.values));
    }
    text += fmt::format(
        "            esac\n            if [[ $current == -* ]]; then\n                _ashimpact_words "
        "'{}'\n",
        names_of(command));
    if (!command.arguments.empty()) {
        text += fmt::format("            else\n                {}\n",
                            action_of(command.arguments.front().values));
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

}  // namespace

std::string bash_completion(const ProgramPaper& paper) {
    std::string commands;
    std::string text = helpers;
    for (const CommandPaper& command : paper.commands) {
        text += command_case(command);
        commands += " " + command.name;
    }
    text += fmt::format(
        "        '') _ashimpact_words '{}{}' ;;\n    esac\n}}\n\ncomplete -F _ashimpact ashimpact\n",
        names_of(paper.program), commands);
    return text;
}

}  // namespace ashimpact
