// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/quantities/quantity.hpp"

namespace ashimpact {

/// A value and its unit for a reader: four significant digits in the unit that keeps the number short
/// ("44 um", "148.1 GPa"). Files never hold this form.
[[nodiscard]] std::string readable(double value, std::string_view unit);

/// The same with its standard uncertainty of two digits, "148.1 +- 9.2 GPa", and the value to its last digit;
/// without it where it is below a ten-thousandth of the value.
[[nodiscard]] std::string readable(const Quantity& quantity);

/// What "+-" means, as a line, for a text that has one; else nothing.
[[nodiscard]] std::string uncertainty_legend(std::string_view text);

/// A number for a reader, with that many significant digits.
[[nodiscard]] std::string readable_number(double value, int digits = 4);

}  // namespace ashimpact
