// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document/fields.hpp"
#include "pipeline/run/results/sizes.hpp"

/// Fields of the comparison of damping laws and of the critical velocities by size.
namespace ashimpact {

inline constexpr FieldColumn<DampedImpact> damped_columns[]{
    {"velocity", &DampedImpact::velocity, Dimension::velocity},
    {"restitution", &DampedImpact::restitution, Dimension::fraction}};

inline constexpr FieldColumn<VelocityOfSize> velocity_of_size_columns[]{
    {"diameter", &VelocityOfSize::diameter, Dimension::length},
    {"critical_velocity", &VelocityOfSize::velocity, Dimension::velocity},
    {"exponent", &VelocityOfSize::exponent, Dimension::fraction}};

void fields(auto& io, Is<DampedSample> auto& sample) {
    io("name", sample.name);
    io("verdict", sample.verdict);
    io("critical_velocity", sample.velocity, Dimension::velocity);
    io.object("curve", [&](auto& inner) { inner.columns(sample.curve, damped_columns, false); });
}

void fields(auto& io, Is<ComparedDamping> auto& damping) {
    io("damping_law", damping.law);
    io("constants", damping.constants, AnyUnit{});
    io.unless_empty("correlation", damping.correlation);
    io("misfit", damping.misfit);
    io("evidence", damping.evidence);
    io("samples", damping.samples);
}

void fields(auto& io, Is<DampingComparison> auto& comparison) {
    io("law", comparison.law);
    io("laws", comparison.laws);
}

void fields(auto& io, Is<SizeVelocity> auto& row) {
    io("diameter", row.diameter, Dimension::length);
    io("assumption", row.basis);
    io("verdict", row.verdict);
    io("critical_velocity", row.velocity, Dimension::velocity);
    io("interval", row.interval, Dimension::velocity);
}

void fields(auto& io, Is<SizeRange> auto& range) {
    io("from", range.from, Dimension::length);
    io("to", range.to, Dimension::length);
}

void fields(auto& io, Is<PowerOfDiameter> auto& power) {
    io("exponent", power.exponent, AnyUnit{});  // two close sizes leave it as uncertain as they like
    io("damping", power.damping, AnyUnit{});
    io("diameter", power.diameter, Dimension::length);
}

void fields(auto& io, Is<LawBySize> auto& by_size) {
    io("law", by_size.law);
    io.object("curve", [&](auto& inner) { inner.columns(by_size.curve, velocity_of_size_columns, false); });
}

void fields(auto& io, Is<SizeSummary> auto& summary) {
    io("law", summary.law);
    io("measured", summary.measured);
    io.derived("factor", agreement_factor);
    io("agreement", summary.agreement);
    io("constants_from", summary.constants);
    io.unless_empty("coefficients", summary.coefficients, AnyUnit{});
    io.unless_empty("power_of_size", summary.power);
}

}  // namespace ashimpact
