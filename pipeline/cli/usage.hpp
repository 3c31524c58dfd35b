#pragma once

#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace ashimpact {

/// One line on a command line that could not be parsed: command, what is wrong, what is allowed, where help
/// is.
[[nodiscard]] std::string usage_error(const CLI::App& program, const CLI::Error& error);

}  // namespace ashimpact
