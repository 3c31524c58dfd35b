// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Validator;
}  // namespace CLI

namespace ashimpact {

/// Has every option and argument of the program's commands refuse an empty value, which is none, and those
/// that name a file or folder the "-" that elsewhere means a stream.
void refuse_empty_values(CLI::App& program);

/// That the argument is a whole number from @p least to @p most.
[[nodiscard]] CLI::Validator whole_number(std::size_t least, std::size_t most);

/// That the argument is a number from @p least to @p most.
[[nodiscard]] CLI::Validator number_within(double least, double most);

}  // namespace ashimpact
