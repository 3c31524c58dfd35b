// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document/fields.hpp"
#include "pipeline/document/sizes_fields.hpp"
#include "pipeline/run/results/deposition.hpp"

/// Fields of deposit.json.
namespace ashimpact {

void fields(auto& io, Is<TubeConditions> auto& tube) {
    io("diameter", tube.diameter, Dimension::length);
    io("gas_velocity", tube.velocity, Dimension::velocity);
    io("gas_temperature", tube.temperature, Dimension::temperature);
    io("gas_density", tube.density, Dimension::density);
    io("gas_viscosity", tube.viscosity, Dimension::viscosity);
    io("gas_viscosity_given", tube.viscosity_given);
    io("ash_load", tube.load, Dimension::density);
    io("sizes", tube.sizes);
}

void fields(auto& io, Is<DepositionSpan> auto& span) {
    io("least", span.least, Dimension::fraction);
    io("greatest", span.greatest, Dimension::fraction);
}

/// A share under a key, its span under that and "_span".
void share_fields(auto& io, std::string_view key, Is<SpannedShare> auto& share) {
    io(key, share.value, Dimension::fraction);
    io(std::string(key) + "_span", share.span);
}

/// The means of what rebounds, beside other fields.
void rebound_fields(auto& io, Is<ReboundMeans> auto& rebound) {
    io("restitution", rebound.restitution, Dimension::fraction);
    io("rebound_velocity", rebound.velocity, Dimension::velocity);
}

void fields(auto& io, Is<DepositedSize> auto& size) {
    io("diameter", size.diameter, Dimension::length);
    io("from", size.from, Dimension::length);
    io("to", size.to, Dimension::length);
    io("mass_fraction", size.mass_fraction, Dimension::fraction);
    io("density", size.density, Dimension::density);
    io("stokes_number", size.stokes);
    io("effective_stokes_number", size.effective_stokes);
    io("impaction_efficiency", size.impaction_efficiency, Dimension::fraction);
    io("critical_velocity", size.critical_velocity, Dimension::velocity);
    io("normal_velocity", size.normal_velocity, Dimension::velocity);
    share_fields(io, "stick_fraction", size.stick_fraction);
    rebound_fields(io, size.rebound);
    io("arrival_flux", size.arrival_flux, AnyUnit{});
    io("deposition_flux", size.deposition_flux, AnyUnit{});
}

void fields(auto& io, Is<DepositedArc> auto& arc) {
    io("from", arc.from, Dimension::angle);
    io("to", arc.to, Dimension::angle);
    io("arrives", arc.arrives, Dimension::fraction);
    io("stays", arc.stays, Dimension::fraction);
    io("normal_velocity", arc.normal_velocity, Dimension::velocity);
    io("incidence", arc.incidence, Dimension::angle);
    rebound_fields(io, arc.rebound);
    io("arrival_flux", arc.arrival_flux, AnyUnit{});
    io("deposition_flux", arc.deposition_flux, AnyUnit{});
}

void fields(auto& io, Is<AssumedDeposition> auto& assumed) {
    io("assumption", assumed.basis);
    share_fields(io, "stick_fraction", assumed.stays);
    io("deposition_flux", assumed.deposition_flux, AnyUnit{});
}

void fields(auto& io, Is<DepositionTotal> auto& total) {
    io("impaction_efficiency", total.impaction_efficiency, Dimension::fraction);
    share_fields(io, "stick_fraction", total.stick_fraction);
    rebound_fields(io, total.rebound);
    io("half_angle", total.half_angle, Dimension::angle);
    io("supported_fraction", total.supported_fraction, Dimension::fraction);
    io.unless_empty("outside_model_fraction", total.outside_model, Dimension::fraction);
    io("deposition_flux", total.deposition_flux, AnyUnit{});
    io("least_deposition_flux", total.least_flux, AnyUnit{});
    io("greatest_deposition_flux", total.greatest_flux, AnyUnit{});
    io("deposition_rate", total.deposition_rate, AnyUnit{});
}

void fields(auto& io, Is<DepositionResult> auto& result) {
    io("tube", result.tube);
    io("law", result.law);
    io("assumption", result.basis);
    io("measured", result.measured);
    io("total", result.total);
    io("sizes", result.sizes);
    io("angles", result.angles);
    io("assumptions", result.assumptions);
}

}  // namespace ashimpact
