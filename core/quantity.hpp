// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/units/units.hpp"

namespace ashimpact {

/// A value as it stands in an artifact: always SI once it is inside the program.
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
[[nodiscard]] Quantity read_quantity(const nlohmann::json& node, Dimension expected);
[[nodiscard]] Quantity read_quantity(const nlohmann::ordered_json& node, Dimension expected);

/// Writes {"value", "unit"}, and "standard_uncertainty" where there is one.
void to_json(nlohmann::json& node, const Quantity& quantity);
void to_json(nlohmann::ordered_json& node, const Quantity& quantity);

}  // namespace ashimpact
