// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/regime_json.hpp"

#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"

namespace ashimpact {

Json regime_json(const Regime& regime) {
    return {{"tabor_parameter", regime.tabor_parameter},
            {"equilibrium_separation", quantity_json(regime.equilibrium_separation, Dimension::length)},
            {"adhesion", name_of(regime.adhesion)},
            {"transition_parameter", regime.transition_parameter},
            {"greatest_pressure", quantity_json(regime.greatest_pressure, Dimension::pressure)},
            {"yield_pressure", quantity_json(regime.yield_pressure, Dimension::pressure)},
            {"damping_number", regime.damping_number},
            {"adhesion_number", regime.adhesion_number},
            {"yield_velocity", quantity_json(regime.yield_velocity, Dimension::velocity)},
            {"law_yield_velocity", quantity_json(regime.law_yield_velocity, Dimension::velocity)},
            {"yields", regime.yields},
            {"contact_radius", quantity_json(regime.contact_radius, Dimension::length)},
            {"relative_contact_radius", regime.relative_contact_radius},
            {"relative_overlap", regime.relative_overlap},
            {"warnings", texts_of(regime.warnings)}};
}

Regime read_regime(const View& node) {
    const auto number = [&](const char* key, Dimension dimension) -> std::optional<double> {
        return number_if(node, key, dimension);
    };
    const auto plain = [&](const char* key) { return number(key, Dimension::fraction).value_or(0); };
    Regime regime{.tabor_parameter = plain("tabor_parameter"),
                  .equilibrium_separation = number("equilibrium_separation", Dimension::length).value_or(0),
                  .transition_parameter = plain("transition_parameter"),
                  .damping_number = plain("damping_number"),
                  .adhesion_number = plain("adhesion_number"),
                  .contact_radius = number("contact_radius", Dimension::length).value_or(0),
                  .relative_contact_radius = plain("relative_contact_radius"),
                  .relative_overlap = plain("relative_overlap"),
                  .greatest_pressure = number("greatest_pressure", Dimension::pressure).value_or(0),
                  .yield_pressure = number("yield_pressure", Dimension::pressure),
                  .yield_velocity = number("yield_velocity", Dimension::velocity),
                  .law_yield_velocity = number("law_yield_velocity", Dimension::velocity)};
    for (const std::string& text : node.at("warnings").texts())
        regime.warnings.push_back({regime_code, Severity::remark, text});
    if (const auto adhesion = node.find("adhesion"))
        regime.adhesion = named<AdhesionRegime>(adhesion->text());
    if (const auto yields = node.find("yields")) regime.yields = yields->truth();
    return regime;
}

}  // namespace ashimpact
