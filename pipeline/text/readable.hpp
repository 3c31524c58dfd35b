#pragma once

#include <string>
#include <string_view>

#include "materials/base/quantity.hpp"

namespace ashimpact {

/// A value and its unit for a reader: four significant digits in the unit that keeps the number short
/// ("44 um", "148.1 GPa"). Files never hold this form.
[[nodiscard]] std::string readable(double value, std::string_view unit);
[[nodiscard]] std::string readable(const Quantity& quantity);

/// A number for a reader, with that many significant digits.
[[nodiscard]] std::string readable_number(double value, int digits = 4);

}  // namespace ashimpact
