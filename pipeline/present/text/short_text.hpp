// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/json/document.hpp"

namespace ashimpact {

/// {"value", "unit"} with a number.
[[nodiscard]] bool is_quantity(const Json& value);
/// {"values", "unit"} with more numbers than one, or none.
[[nodiscard]] bool is_column(const Json& value);
/// {"level", "lower", "upper"}.
[[nodiscard]] bool is_interval(const Json& value);

/// A value that fits behind its name: a text, a number, a quantity, an interval, a list of such; else
/// nothing.
[[nodiscard]] std::optional<std::string> short_text(const Json& value);

/// The number of a table's cell; what is only rounding of other numbers (below 1e-12) is 0.
[[nodiscard]] std::string cell_number(double value, int digits = 4);

}  // namespace ashimpact
