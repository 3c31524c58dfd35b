// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/quantity_json.hpp"

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

}  // namespace ashimpact
