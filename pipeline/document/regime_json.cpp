// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/regime_json.hpp"

#include "pipeline/document/quantity_json.hpp"

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
            {"warnings", regime.warnings}};
}

}  // namespace ashimpact
