// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/version.hpp"
#include "pipeline/app/man/man.hpp"

namespace ashimpact {

namespace {

/// Text that roff prints as it is.
std::string roff(const std::string& text) {
    std::string result;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\'')) result += "\\&";
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else {
            result += c;
        }
        line_begins = c == '\n';
    }
    return result;
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
    if (names.empty()) {
        names = type;
    } else if (!type.empty()) {
        names += " " + type;
    }
    std::string text = option.description;
    if (option.required) text += " (required)";
    if (!option.default_value.empty()) text += " (default: " + option.default_value + ")";
    if (option.values.kind == Values::Kind::words)
        text += fmt::format(". One of: {}", fmt::join(option.values.words, ", "));
    return ".TP\n" + names + "\n" + roff(text) + "\n";
}

std::string synopsis(const CommandEntry& command) {
    std::string line = ".B ashimpact " + roff(command.name) + "\n";
    for (const OptionEntry& option : command.options) {
        if (!option.required) continue;
        line += fmt::format("\\fB{}\\fR \\fI{}\\fR\n", roff(option.names.back()), roff(option.type));
    }
    for (const OptionEntry& argument : command.arguments) {
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

constexpr auto exit_status =
    ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n2\nThe input is wrong; one line on standard error says where, "
    "what, and "
    "what is allowed.\n.TP\n3\nA computation did not converge.\n.TP\n1\nA defect of the program.\n";

/// Text inside a cell of a table.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string row(const OptionEntry& option) {
    std::string name = fmt::format("{}", fmt::join(option.names, "`, `"));
    if (!option.type.empty()) name += (name.empty() ? "" : " ") + option.type;
    std::string values;
    if (option.values.kind == Values::Kind::words)
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

}  // namespace

std::string man_page(const ProgramEntry& entry) {
    std::string page =
        heading("ashimpact", "from an XRD result of fly ash to the critical velocity of impact");
    page += ".SH SYNOPSIS\n.B ashimpact\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" +
            roff(entry.program.purpose) + "\n.SH COMMANDS\n";
    for (const CommandEntry& command : entry.commands) {
        page += fmt::format(".TP\n\\fB{}\\fR\n{}; see\n.BR ashimpact\\-{} (1).\n", roff(command.name),
                            roff(command.purpose), roff(command.name));
    }
    page += ".SH OPTIONS\n";
    for (const OptionEntry& option : entry.program.options) page += option_entry(option);
    page += example_section(entry.program.example) + exit_status;
    page +=
        ".SH FILES\n.TP\n\\fIresults/\\fR\nWhere \\fBashimpact run\\fR writes its artifacts, unless told "
        "otherwise.\n";
    return page;
}

std::string man_page(const ProgramEntry& entry, const CommandEntry& command) {
    std::string page = heading("ashimpact-" + command.name, command.purpose);
    page += ".SH SYNOPSIS\n" + synopsis(command) + ".SH DESCRIPTION\n" + roff(command.purpose) +
            ".\n.PP\nQuantities carry their unit in quotes, \"44 um\"; a bare number is SI.\n";
    if (!command.arguments.empty()) page += ".SH ARGUMENTS\n";
    for (const OptionEntry& argument : command.arguments) page += option_entry(argument);
    page += ".SH OPTIONS\n";
    for (const OptionEntry& option : command.options) page += option_entry(option);
    page += example_section(command.example) + exit_status + ".SH SEE ALSO\n.BR ashimpact (1)";
    for (const CommandEntry& other : entry.commands) {
        if (other.name != command.name) page += fmt::format(",\n.BR ashimpact\\-{} (1)", roff(other.name));
    }
    return page + "\n";
}

std::string reference_page(const ProgramEntry& entry) {
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
    for (const CommandEntry& command : entry.commands) {
        page += fmt::format("## ashimpact {}\n\n{}.\n\n", command.name, command.purpose);
        if (!command.arguments.empty()) page += table(command.arguments);
        page += table(command.options) + "```text\n" + example_of(command.example) + "\n```\n\n";
    }
    return page;
}

}  // namespace ashimpact
