// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/units/units.hpp"

namespace ashimpact {

/// A value with its unit; inside the program always SI.
struct Quantity {
    double value = 0;
    std::string unit = "1";
    std::optional<double> standard_uncertainty{};  ///< in the unit of the value
};

/// A quantity from a value that is already SI.
[[nodiscard]] Quantity make_quantity(double value, Dimension dimension,
                                     std::optional<double> standard_uncertainty = std::nullopt);

/// Reads a quantity from a case or an artifact: a bare number (SI), a string with its unit ("44 um"), or
/// {"value", "unit", "standard_uncertainty"} in any convertible unit. Returns it in SI.
/// Errors: InputError, with the JSON pointer relative to `node` as its place.
[[nodiscard]] Quantity read_quantity(const nlohmann::ordered_json& node, Dimension expected);

/// Reads "60 um", "60 +- 3 um", "60 um +- 5 %" or "60(3) um"; a number alone is SI. Errors as
/// read_quantity().
[[nodiscard]] Quantity quantity_of_text(const std::string& text, Dimension expected);

/// Writes {"value", "unit"}, and "standard_uncertainty" where there is one.
void to_json(nlohmann::ordered_json& node, const Quantity& quantity);

}  // namespace ashimpact
