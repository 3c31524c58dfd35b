// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "core/quantity.hpp"

namespace ashimpact {

/// {"value", "unit"} of a value in SI.
[[nodiscard]] Json quantity_json(double value, Dimension dimension);
[[nodiscard]] Json quantity_json(double value, std::string_view unit);

/// The same, or null where there is none.
[[nodiscard]] Json quantity_json(const std::optional<double>& value, Dimension dimension);

/// {"values", "unit"} of values in SI.
[[nodiscard]] Json column_json(const std::vector<double>& values, Dimension dimension);

}  // namespace ashimpact
