// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document/fields.hpp"
#include "pipeline/run/results/contact.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"

/// Fields of structs that several artifacts have.
namespace ashimpact {

/// What is known of impacts beside their velocities.
void noise_fields(auto& io, Is<ListedImpacts> auto& columns) {
    io.unless_empty("velocity_uncertainty", columns.velocity_uncertainty, Dimension::velocity);
    io.unless_empty("rebound_uncertainty", columns.rebound_uncertainty, Dimension::velocity);
    io.unless_empty("velocity_correlation", columns.correlation, Dimension::fraction);
    io.unless_empty("impacts", columns.counts, Dimension::fraction);
}

void fields(auto& io, Is<ListedImpacts> auto& columns) {
    io("velocity", columns.velocity, Dimension::velocity);
    io("restitution", columns.restitution, Dimension::fraction);
    noise_fields(io, columns);
}

void fields(auto& io, Is<CriticalVelocityCheck> auto& check) {
    io("verdict", check.verdict);
    io("deviation", check.deviation, NullIfNotFinite{});
}

}  // namespace ashimpact
