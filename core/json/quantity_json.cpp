// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/quantity_json.hpp"

#include <algorithm>
#include <cmath>

#include "core/text/text.hpp"

namespace ashimpact {

Json quantity_json(double value, Dimension dimension) {
    return quantity_json(value, si_unit(dimension));
}

Json quantity_json(double value, std::string_view unit) {
    return {{"value", value}, {"unit", unit}};
}

Json quantity_json(const std::optional<double>& value, Dimension dimension) {
    return value ? quantity_json(*value, dimension) : Json(nullptr);
}

Json column_json(const std::vector<double>& values, Dimension dimension) {
    return {{"values", values}, {"unit", si_unit(dimension)}};
}

void require_agreement(const View& value, double expected, Dimension dimension, const std::string& problem,
                       const std::string& others) {
    constexpr double same_number = 1e-9;
    const double number = value.number(dimension);
    if (std::abs(number - expected) <= same_number * std::max(std::abs(number), std::abs(expected))) return;
    value.fail(problem, shortest(expected) + " " + std::string(si_unit(dimension)) + ", or edit " + others +
                            " as well");
}

}  // namespace ashimpact
