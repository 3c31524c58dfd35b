// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Error;
}  // namespace CLI

namespace ashimpact {

/// The word that starts this program in the user's shell: as it was typed.
[[nodiscard]] const std::string& program_word();
void set_program_word(const char* typed);

/// The help of a command in lines of at most @p width characters. Descriptions are wrapped within their
/// column, commands of examples with a backslash, so that they can be pasted. program_word() replaces
/// "ashimpact" at the start of an example.
[[nodiscard]] std::string help_layout(const std::string& help, std::size_t width);

/// One line on a command line that could not be parsed: command, what is wrong, what is allowed, where help
/// is.
[[nodiscard]] std::string usage_error(const CLI::App& program, const CLI::Error& error);

}  // namespace ashimpact
