// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/fields.hpp"
#include "pipeline/document/results_json.hpp"

namespace ashimpact {

void fields(auto& io, Is<StageMomentum> auto& stage) {
    io("duration", stage.duration, Dimension::time);
    io("static_impulse", stage.static_impulse, Dimension::impulse);
    io("damping_impulse", stage.damping_impulse, Dimension::impulse);
    io("mean_force", stage.mean_force, Dimension::force);
    io("residual", stage.residual, Dimension::impulse);
}

void fields(auto& io, Is<HistoryMomentum> auto& momentum) {
    io("approach", momentum.approach);
    io("rebound", momentum.rebound);
    io("mean_force_ratio", momentum.mean_force_ratio);
    io.object("equation_44", [&](auto& inner) {
        inner("damping_impulse", momentum.damping_impulse, Dimension::impulse);
        inner("momentum_lost", momentum.momentum_lost, Dimension::impulse);
        inner("holds", momentum.damping_exceeds_loss);
    });
    io.object("equation_45", [&](auto& inner) {
        inner.derived("approach_time", momentum.approach.duration, Dimension::time);
        inner.derived("rebound_time", momentum.rebound.duration, Dimension::time);
        inner("holds", momentum.rebound_is_longer);
    });
    io("verdict", momentum.verdict);
}

constexpr FieldColumn<TrajectoryPoint> trajectory_columns[]{
    {"time", &TrajectoryPoint::time, Dimension::time},
    {"overlap", &TrajectoryPoint::overlap, Dimension::length},
    {"velocity", &TrajectoryPoint::velocity, Dimension::velocity},
    {"contact_radius", &TrajectoryPoint::contact_radius, Dimension::length},
    {"repulsive_force", &TrajectoryPoint::repulsive_force, Dimension::force},
    {"attractive_force", &TrajectoryPoint::attractive_force, Dimension::force},
    {"damping_force", &TrajectoryPoint::damping_force, Dimension::force}};

void fields(auto& io, Is<History> auto& history) {
    io("part", history.part);
    io("velocity", history.velocity, Dimension::velocity);
    io.lenient("damping", history.damping, dimension_of(io.damping_law()));
    if (!is_of_a_curve(history.part)) {
        io.lenient("outcome", history.outcome);
        io.lenient("restitution", history.restitution, Dimension::fraction);
        io("contact_time", history.contact_time, Dimension::time);
        io.lenient("maximum_overlap", history.maximum_overlap, Dimension::length);
        io.lenient("greatest_pressure", history.greatest_pressure, Dimension::pressure);
        io("yield_pressure", history.yield_pressure, Dimension::pressure);
        io.unless_empty("momentum", history.momentum);
    }
    io.object("trajectory",
              [&](auto& inner) { inner.columns(history.trajectory, trajectory_columns, false); });
}

void fields(auto& io, Is<ContactTimeAt> auto& time) {
    io("law", time.law);
    io("velocity", time.velocity, Dimension::velocity);
    io("restitution", time.restitution, Dimension::fraction);
    io("contact_time", time.contact_time, Dimension::time);
}

constexpr FieldColumn<CurveImpact> curve_columns[]{
    {"velocity", &CurveImpact::velocity, Dimension::velocity},
    {"lower_velocity", &CurveImpact::lower, Dimension::velocity},
    {"upper_velocity", &CurveImpact::upper, Dimension::velocity},
    {"restitution", &CurveImpact::restitution, Dimension::fraction},
    {"damping", &CurveImpact::damping, Dimension::damping, true},
    {"contact_time", &CurveImpact::contact_time, Dimension::time},
    {"dissipated", &CurveImpact::dissipated, Dimension::fraction},
    {"adhesion", &CurveImpact::adhesion, Dimension::fraction},
    {"plastic", &CurveImpact::plastic, Dimension::fraction}};

void fields(auto& io, Is<LawCurve> auto& curve) {
    io("start", curve.start, Dimension::velocity);
    io.lenient("histories", curve.histories);
    io.columns(curve.impacts, curve_columns, true);
}

void fields(auto& io, Is<SampleHistories> auto& sample) {
    io("name", sample.name);
    io.lenient("contact_times", sample.contact_times);
    io.under_laws(sample.laws, {"name", "contact_times", "curves"});
    io.lenient("curves", sample.curves);
}

template Json to_json(const HistoriesResult& result, DampingLaw law);
template HistoriesResult from_json(const View& result, DampingLaw law);

}  // namespace ashimpact
