// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/app/man/command.hpp"

namespace ashimpact {

/// The manual page of the program, section 1, or of one of its commands (roff with the macros of man).
[[nodiscard]] std::string man_page(const ProgramPaper& paper);
[[nodiscard]] std::string man_page(const ProgramPaper& paper, const CommandPaper& command);

/// What bash and zsh source to complete commands, options and their values.
[[nodiscard]] std::string bash_completion(const ProgramPaper& paper);
[[nodiscard]] std::string zsh_completion(const ProgramPaper& paper);

/// The page of the reference that lists all commands (Markdown).
[[nodiscard]] std::string reference_page(const ProgramPaper& paper);

}  // namespace ashimpact
