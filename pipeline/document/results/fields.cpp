// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/fields.hpp"

#include "core/json/view.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

Json bounds_json(const Bounds& bounds, Dimension dimension) {
    return {{"level", confidence},
            {"lower", quantity_json(bounds.lower, dimension)},
            {"upper", quantity_json(bounds.upper, dimension)}};
}

Json bounds_json(const std::optional<Bounds>& bounds, Dimension dimension) {
    return bounds ? bounds_json(*bounds, dimension) : Json(nullptr);
}

Bounds read_bounds(const View& node, Dimension dimension) {
    return {number_if(node, "lower", dimension), number_if(node, "upper", dimension)};
}

Json velocity_json(const VelocityEstimate& velocity) {
    Json json = quantity_json(velocity.value, Dimension::velocity);
    if (velocity.standard_uncertainty) json["standard_uncertainty"] = *velocity.standard_uncertainty;
    return json;
}

Json headline_json(const VelocityEstimate& velocity) {
    Json json = velocity_json(velocity);
    json["interval"] = bounds_json(velocity.interval, Dimension::velocity);
    if (velocity.method) json["method"] = name_of(*velocity.method);
    return json;
}

VelocityEstimate read_velocity(const View& node) {
    const View unit = node.at("unit");
    if (unit.text() != si_unit(Dimension::velocity))
        unit.fail("is " + in_quotes(unit.text()), std::string(si_unit(Dimension::velocity)));
    const View value = node.at("value");
    VelocityEstimate velocity{.value = value.number(Dimension::velocity)};
    at_place(value.pointer(),
             [&] { require_positive("critical velocity", velocity.value, Dimension::velocity); });
    velocity.standard_uncertainty = number_if(node, "standard_uncertainty", Dimension::velocity);
    velocity.interval = read_if(
        node, "interval", [](const View& interval) { return read_bounds(interval, Dimension::velocity); });
    velocity.method = read_if(node, "method", [](const View& method) {
        return at_place(method.pointer(), [&] { return named<VelocityMethod>(method.text()); });
    });
    return velocity;
}

}  // namespace ashimpact
