// SPDX-License-Identifier: GPL-3.0-or-later
// ashimpact-papers: manual pages, completions and the reference page, from the command line itself.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/version.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

/// What may stand for the value of an option or an argument.
struct Values {
    std::string bash{};                ///< the call that completes it; empty: a flag has no value
    std::string zsh{};                 ///< the action of _arguments
    std::vector<std::string> words{};  ///< all that are allowed; empty: anything
};

/// An option, or an argument if it has no names.
struct OptionEntry {
    std::vector<std::string> names{};  ///< "-o", "--output"
    std::string type{};                ///< as help shows it: "Q", "FILE"
    std::string description{};
    std::string default_value{};  ///< empty: none
    bool required = false;
    bool repeats = false;  ///< may be given more than once
    Values values{};
};

using Words = std::vector<std::string>;

Words law_words() {
    Words words;
    for (std::size_t i = 0; i < Law::count(); ++i) words.emplace_back(Law::at(i).name());
    return words;
}

/// Units that people write, by what the option measures.
const std::map<std::string, Words>& units() {
    static const Words lengths{"um", "nm", "mm", "m"};
    static const Words pressures{"GPa", "MPa", "Pa"};
    static const Words velocities{"m/s", "mm/s", "cm/s"};
    static const Words densities{"kg/m3", "g/cm3"};
    static const std::map<std::string, Words> all{{"--radius", lengths},
                                                  {"--diameter", lengths},
                                                  {"--pixel-size", lengths},
                                                  {"--cohesion-range", {"nm", "m"}},
                                                  {"--contact-modulus", pressures},
                                                  {"--yield-pressure", pressures},
                                                  {"--cohesive-stress", pressures},
                                                  {"--velocity", velocities},
                                                  {"--at", velocities},
                                                  {"--density", densities},
                                                  {"--particle-density", densities},
                                                  {"--mass", {"kg", "ug", "ng"}},
                                                  {"--work-of-adhesion", {"J/m2", "mJ/m2"}},
                                                  {"--damping", {"kg/s", "Pa s", "1"}},
                                                  {"--time-step", {"ns", "ps", "s"}},
                                                  {"--tube-diameter", {"mm", "m"}},
                                                  {"--gas-velocity", velocities},
                                                  {"--gas-temperature", {"C", "K"}},
                                                  {"--gas-viscosity", {"uPa s", "Pa s"}},
                                                  {"--ash-load", {"g/m3", "g/Nm3"}}};
    return all;
}

/// The words of options that take a name from a list.
const std::map<std::string, Words>& names() {
    static const std::map<std::string, Words> all{
        {"--law", law_words()},
        {"--detachment", names_of<Detachment>()},
        {"--damping-law", names_of<DampingLaw>()},
        {"--method", {"taylor", "paper-explicit"}},
        {"--from", stage_names()},
        {"--only", stage_names()},
        {"--phase-set", {"literature", "dong2013"}},
        {"--assumption", names_of<SizeBasis>()},
        {"--free", {"density", "work_of_adhesion", "contact_modulus", "wall_young_modulus", "time_step"}}};
    return all;
}

/// Text inside a specification of _arguments in single quotes.
std::string quoted(const std::string& text) {
    const std::string escaped = std::regex_replace(text, std::regex(R"([\[\]:\\])"), R"(\$&)");
    return std::regex_replace(std::regex_replace(escaped, std::regex("'"), R"('\'')"), std::regex("\n"), " ");
}

/// What may stand for the value of an option of a command, by the kind that its help shows.
Values values_of(const std::string& command, const std::string& option, const std::string& type) {
    if (type == "DIR") return {.bash = "_ashimpact_folders", .zsh = "_files -/"};
    if (type == "FILE") return {.bash = "_ashimpact_files ''", .zsh = "_files"};
    if (type.ends_with(".json"))
        return {.bash = "_ashimpact_files '.json'", .zsh = "_files -g \"*.json(-.)\""};
    if (const auto unit = units().find(option); unit != units().end())
        return {.bash = fmt::format("_ashimpact_quantity '{}'", fmt::join(unit->second, "' '")),
                .zsh = fmt::format("_ashimpact_quantity \"{}\" ", fmt::join(unit->second, "\" \""))};
    const auto listed = names().find(option);
    if (command != "schema" && listed == names().end()) return {.bash = "return", .zsh = " "};
    const Words words = command == "schema" ? schema_names() : listed->second;
    return {.bash = fmt::format("_ashimpact_words '{}'", fmt::join(words, " ")),
            .zsh = quoted(fmt::format("({})", fmt::join(words, " "))),
            .words = words};
}

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

OptionEntry entry_of(const std::string& command, const CLI::Option& option) {
    const bool is_flag = option.get_expected_max() == 0;
    OptionEntry entry{.names = names_of(option),
                      .type = is_flag ? "" : type_of(option),
                      .description = option.get_description(),
                      .default_value = is_flag ? "" : option.get_default_str(),
                      .required = option.get_required(),
                      .repeats = option.get_expected_max() > 1};
    const std::string& name = entry.names.empty() ? option.get_single_name() : entry.names.back();
    if (!is_flag) entry.values = values_of(command, name, entry.type);
    return entry;
}

/// The options of a command, or its arguments.
std::vector<OptionEntry> options_of(const CLI::App& command, bool arguments = false) {
    std::vector<OptionEntry> options;
    for (const CLI::Option* option : command.get_options())
        if (OptionEntry entry = entry_of(command.get_name(), *option); entry.names.empty() == arguments)
            options.push_back(std::move(entry));
    return options;
}

/// All commands, in the order of the help.
std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App*) { return true; });
}

// Completions.

std::string names_of(const CLI::App& command) {
    Words names;
    for (const OptionEntry& option : options_of(command))
        names.insert(names.end(), option.names.begin(), option.names.end());
    return fmt::format("{}", fmt::join(names, " "));
}

/// The cases of one command: options by the word before, then its options and arguments.
std::string command_case(const CLI::App& command) {
    std::string text = fmt::format("        {})\n            case $previous in\n", command.get_name());
    for (const OptionEntry& option : options_of(command)) {
        if (option.values.bash.empty()) continue;
        text += fmt::format("                {}) {}; return ;;\n", fmt::join(option.names, " | "),
                            option.values.bash);
    }
    text += fmt::format(
        "            esac\n            if [[ $current == -* ]]; then\n                _ashimpact_words "
        "'{}'\n",
        names_of(command));
    if (!options_of(command, true).empty())
        text += fmt::format("            else\n                {}\n",
                            options_of(command, true).front().values.bash);
    return text + "            fi\n            ;;\n";
}

constexpr auto helpers =
    R"(# Completion of ashimpact for bash; generated from the program's own command line.

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

std::string specification(const OptionEntry& option) {
    const std::string value = fmt::format(":{}:{}", quoted(option.type), option.values.zsh);
    if (option.names.empty()) return fmt::format(" '{}{}'", option.required ? "" : ":", value);
    std::string text;
    for (const std::string& name : option.names)
        text += fmt::format(" \\\n                '{}{}[{}]{}'", option.repeats ? "*" : "", name,
                            quoted(option.description), option.values.bash.empty() ? "" : value);
    return text;
}

std::string bash_completion(const CLI::App& program) {
    std::string commands;
    std::string text = helpers;
    for (const CLI::App* command : commands_of(program)) {
        text += command_case(*command);
        commands += " " + command->get_name();
    }
    return text + fmt::format(
                      "        '') _ashimpact_words '{}{}' ;;\n    esac\n}}\n\ncomplete -F _ashimpact "
                      "ashimpact\n",
                      names_of(program), commands);
}

std::string zsh_completion(const CLI::App& program) {
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
    for (const CLI::App* command : commands_of(program))
        text += fmt::format("        '{}:{}'\n", command->get_name(), quoted(command->get_description()));
    text += "    )\n    _arguments -C";
    for (const OptionEntry& option : options_of(program)) text += specification(option);
    text +=
        " \\\n                '1:command:->command' '*::argument:->argument'\n"
        "    case $state in\n"
        "        command) _describe command commands ;;\n"
        "        argument)\n            case $line[1] in\n";
    for (const CLI::App* command : commands_of(program)) {
        text += fmt::format("            {}) _arguments", command->get_name());
        for (const OptionEntry& option : options_of(*command)) text += specification(option);
        for (const OptionEntry& argument : options_of(*command, true)) text += specification(argument);
        text += " ;;\n";
    }
    return text + "            esac ;;\n    esac\n}\n\n_ashimpact \"$@\"\n";
}

// Pages.

/// Text that roff prints as it is.
std::string roff(const std::string& text) {
    const std::string escaped = std::regex_replace(text, std::regex(R"(\\)"), R"(\e)");
    return std::regex_replace(std::regex_replace(escaped, std::regex("-"), R"(\-)"),
                              std::regex(R"((^|\n)([.']))"), R"($1\&$2)");
}

std::string heading(const std::string& name, const std::string& purpose) {
    return fmt::format(".TH {} 1 \"\" \"ashimpact {}\" \"ashimpact\"\n.SH NAME\n{} \\- {}\n", roff(name),
                       roff(std::string(program_version())), roff(name), roff(purpose));
}

std::string option_entry(const OptionEntry& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
    const std::string type = option.type.empty() ? "" : fmt::format("\\fI{}\\fR", roff(option.type));
    if (!type.empty()) names += (names.empty() ? "" : " ") + type;
    std::string text = option.description;
    if (option.required) text += " (required)";
    if (!option.default_value.empty()) text += " (default: " + option.default_value + ")";
    if (!option.values.words.empty())
        text += fmt::format(". One of: {}", fmt::join(option.values.words, ", "));
    return ".TP\n" + names + "\n" + roff(text) + "\n";
}

std::string synopsis(const CLI::App& command) {
    std::string line = ".B ashimpact " + roff(command.get_name()) + "\n";
    for (const OptionEntry& option : options_of(command)) {
        if (!option.required) continue;
        line += fmt::format("\\fB{}\\fR \\fI{}\\fR\n", roff(option.names.back()), roff(option.type));
    }
    for (const OptionEntry& argument : options_of(command, true)) {
        const std::string name = fmt::format("\\fI{}\\fR", roff(argument.type));
        line += argument.required ? name + "\n" : "[" + name + "]\n";
    }
    return line + "[\\fIOPTIONS\\fR]\n";
}

/// The example in the footer of a command's help.
std::string example_of(const std::string& footer) {
    const std::string word = "Example:\n";
    return footer.starts_with(word) ? footer.substr(word.size()) : footer;
}

std::string example_section(const std::string& footer) {
    return ".SH EXAMPLE\n.nf\n" + roff(example_of(footer)) + "\n.fi\n";
}

constexpr auto exit_status = R"(.SH EXIT STATUS
.TP
0
Done.
.TP
2
The input is wrong; one line on standard error says where, what, and what is allowed.
.TP
3
A computation did not converge.
.TP
1
A defect of the program.
)";

/// Text inside a cell of a table.
std::string cell(const std::string& text) {
    return std::regex_replace(std::regex_replace(text, std::regex(R"(\|)"), R"(\|)"), std::regex("\n"), " ");
}

std::string row(const OptionEntry& option) {
    std::string name = fmt::format("{}", fmt::join(option.names, "`, `"));
    if (!option.type.empty()) name += (name.empty() ? "" : " ") + option.type;
    std::string values;
    if (!option.values.words.empty())
        values = fmt::format(" One of `{}`.", fmt::join(option.values.words, "`, `"));
    const std::string fallback =
        option.default_value.empty() ? "" : " Default: `" + option.default_value + "`.";
    return fmt::format("| `{}` | {}{}.{}{} |\n", name, option.required ? "**required**; " : "",
                       cell(option.description), cell(values), cell(fallback));
}

std::string table(const std::vector<OptionEntry>& options) {
    std::string text = "| option | meaning |\n|---|---|\n";
    for (const OptionEntry& option : options) text += row(option);
    return text + "\n";
}

std::string man_page(const CLI::App& program) {
    std::string page =
        heading("ashimpact", "from an XRD result of fly ash to the critical velocity of impact");
    page += ".SH SYNOPSIS\n.B ashimpact\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" +
            roff(program.get_description()) + "\n.SH COMMANDS\n";
    for (const CLI::App* command : commands_of(program))
        page += fmt::format(".TP\n\\fB{}\\fR\n{}; see\n.BR ashimpact\\-{} (1).\n", roff(command->get_name()),
                            roff(command->get_description()), roff(command->get_name()));
    page += ".SH OPTIONS\n";
    for (const OptionEntry& option : options_of(program)) page += option_entry(option);
    page += example_section(program.get_footer()) + exit_status;
    page +=
        ".SH FILES\n.TP\n\\fIresults/\\fR\nWhere \\fBashimpact run\\fR writes its artifacts, unless told "
        "otherwise.\n";
    return page;
}

std::string man_page(const CLI::App& program, const CLI::App& command) {
    std::string page = heading("ashimpact-" + command.get_name(), command.get_description());
    page += ".SH SYNOPSIS\n" + synopsis(command) + ".SH DESCRIPTION\n" + roff(command.get_description()) +
            ".\n.PP\nQuantities carry their unit in quotes, \"44 um\"; a bare number is SI.\n";
    if (!options_of(command, true).empty()) page += ".SH ARGUMENTS\n";
    for (const OptionEntry& argument : options_of(command, true)) page += option_entry(argument);
    page += ".SH OPTIONS\n";
    for (const OptionEntry& option : options_of(command)) page += option_entry(option);
    page += example_section(command.get_footer()) + exit_status + ".SH SEE ALSO\n.BR ashimpact (1)";
    for (const CLI::App* other : commands_of(program))
        if (other->get_name() != command.get_name())
            page += fmt::format(",\n.BR ashimpact\\-{} (1)", roff(other->get_name()));
    return page + "\n";
}

std::string reference_page(const CLI::App& program) {
    std::string page = R"(# Commands

> **Summary.** Every command of the program is listed with its options. Quantities carry their unit in quotes, `"44 um"`; a bare number is SI. Results go to standard output, messages to standard error. Exit status: 0 done; 2 the input is wrong; 3 a computation did not converge; 1 a defect of the program.

)";
    for (const CLI::App* command : commands_of(program)) {
        page += fmt::format("## ashimpact {}\n\n{}.\n\n", command->get_name(), command->get_description());
        if (!options_of(*command, true).empty()) page += table(options_of(*command, true));
        page += table(options_of(*command)) + "```text\n" + example_of(command->get_footer()) + "\n```\n\n";
    }
    return page;
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (!out) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

}  // namespace ashimpact

/// ashimpact-papers FOLDER: writes manual pages, completions and the reference page there.
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
        const std::filesystem::path folder = argv[1];
        write(folder / "man/ashimpact.1", man_page(program));
        for (const CLI::App* command : commands_of(program))
            write(folder / ("man/ashimpact-" + command->get_name() + ".1"), man_page(program, *command));
        write(folder / "bash/ashimpact", bash_completion(program));
        write(folder / "zsh/_ashimpact", zsh_completion(program));
        write(folder / "reference/commands.md", reference_page(program));
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "ashimpact-papers: " << error.what() << '\n';
        return 1;
    }
}
