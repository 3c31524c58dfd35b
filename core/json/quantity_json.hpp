// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"

namespace ashimpact {

/// {"value", "unit"} of a value in SI.
[[nodiscard]] Json quantity_json(double value, Dimension dimension);
[[nodiscard]] Json quantity_json(double value, std::string_view unit);

/// The same, or null where there is none.
[[nodiscard]] Json quantity_json(const std::optional<double>& value, Dimension dimension);

/// {"values", "unit"} of values in SI.
[[nodiscard]] Json column_json(const std::vector<double>& values, Dimension dimension);

/// Checks that a value agrees with others of its artifact that say the same. Numbers written with fewer
/// digits agree. @throws InputError at the value: @p problem, the @p expected one, @p others to edit as well
void require_agreement(const View& value, double expected, Dimension dimension, const std::string& problem,
                       const std::string& others);

}  // namespace ashimpact
