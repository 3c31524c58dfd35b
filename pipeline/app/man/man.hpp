// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace ashimpact {

/// What may stand for the value of an option or an argument.
struct Values {
    enum class Kind { none, text, words, quantity, file, folder };
    Kind kind = Kind::none;            ///< none: a flag
    std::vector<std::string> words{};  ///< of kind words; of a quantity, units to choose from
    std::string extension{};           ///< of a file, with its dot; empty: any
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

/// A command as its papers need it.
struct CommandEntry {
    std::string name{};
    std::string purpose{};
    std::string example{};  ///< the footer of its help
    std::vector<OptionEntry> options{};
    std::vector<OptionEntry> arguments{};
};

/// The program's own options, and its commands in the order of its help.
struct ProgramEntry {
    CommandEntry program{};
    std::vector<CommandEntry> commands{};
};

/// Walks the command line of the program.
[[nodiscard]] ProgramEntry entry_of(const CLI::App& program);

/// The manual page of the program, section 1, or of one of its commands (roff with the macros of man).
[[nodiscard]] std::string man_page(const ProgramEntry& entry);
[[nodiscard]] std::string man_page(const ProgramEntry& entry, const CommandEntry& command);

/// What bash and zsh source to complete commands, options and their values.
[[nodiscard]] std::string bash_completion(const ProgramEntry& entry);
[[nodiscard]] std::string zsh_completion(const ProgramEntry& entry);

/// The page of the reference that lists all commands (Markdown).
[[nodiscard]] std::string reference_page(const ProgramEntry& entry);

}  // namespace ashimpact
