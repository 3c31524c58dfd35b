// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

/// Numbers as text, in the C locale: what std::from_chars() and std::to_chars() do, by fast_float and fmt, as
/// the standard library of emscripten has them for integers only.
namespace ashimpact::decimal {

/// Reads a number from the front of a text, as std::from_chars() does.
std::from_chars_result read(const char* first, const char* last, double& value);

/// The fewest digits that read back as the same number, "1e+05" rather than "100000" where that is shorter.
[[nodiscard]] std::string shortest(double value);

/// As printf's %.*g prints it.
[[nodiscard]] std::string general(double value, int digits);

/// As printf's %.*e prints it.
[[nodiscard]] std::string scientific(double value, int decimals);

}  // namespace ashimpact::decimal
