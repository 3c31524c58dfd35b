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
struct OptionPaper {
    std::vector<std::string> names{};  ///< "-o", "--output"
    std::string type{};                ///< as help shows it: "Q", "FILE"
    std::string description{};
    std::string default_value{};  ///< empty: none
    bool required = false;
    bool repeats = false;  ///< may be given more than once
    Values values{};
};

/// A command as its papers need it.
struct CommandPaper {
    std::string name{};
    std::string purpose{};
    std::string example{};  ///< the footer of its help
    std::vector<OptionPaper> options{};
    std::vector<OptionPaper> arguments{};
};

/// The program's own options, and its commands in the order of its help.
struct ProgramPaper {
    CommandPaper program{};
    std::vector<CommandPaper> commands{};
};

/// Walks the command line of the program.
[[nodiscard]] ProgramPaper paper_of(const CLI::App& program);

/// What may stand for the value of an option of a command, by the kind that its help shows.
[[nodiscard]] Values values_of(const std::string& command, const std::string& option,
                               const std::string& type);

}  // namespace ashimpact
