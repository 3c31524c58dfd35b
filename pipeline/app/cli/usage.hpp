// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Error;
}  // namespace CLI

namespace ashimpact {

/// One line on a command line that could not be parsed: command, what is wrong, what is allowed, where help
/// is.
[[nodiscard]] std::string usage_error(const CLI::App& program, const CLI::Error& error);

}  // namespace ashimpact
