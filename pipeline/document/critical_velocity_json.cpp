// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/shared_fields.hpp"

namespace ashimpact {

void fields(auto& io, Is<Regime> auto& regime) {
    io.lenient("tabor_parameter", regime.tabor_parameter);
    io.lenient("equilibrium_separation", regime.equilibrium_separation, Dimension::length);
    io.lenient("adhesion", regime.adhesion);
    io.lenient("transition_parameter", regime.transition_parameter);
    io.lenient("greatest_pressure", regime.greatest_pressure, Dimension::pressure);
    io("yield_pressure", regime.yield_pressure, Dimension::pressure);
    io.lenient("damping_number", regime.damping_number);
    io.lenient("adhesion_number", regime.adhesion_number);
    io("yield_velocity", regime.yield_velocity, Dimension::velocity);
    io("law_yield_velocity", regime.law_yield_velocity, Dimension::velocity);
    io.lenient("yields", regime.yields);
    io.lenient("contact_radius", regime.contact_radius, Dimension::length);
    io.lenient("relative_contact_radius", regime.relative_contact_radius);
    io.lenient("relative_overlap", regime.relative_overlap);
    io.by_hand(
        "warnings", regime.warnings,
        [](const std::vector<Finding>& findings) { return Json(texts_of(findings)); },
        [](const View& node) {
            std::vector<Finding> findings;
            for (const std::string& text : node.texts())
                findings.push_back({regime_code, Severity::remark, text});
            return findings;
        });
}

Json regime_json(const Regime& regime) {
    return to_json(regime, DampingLaw::constant);
}

Json check_json(const CriticalVelocityCheck& check) {
    return to_json(check, DampingLaw::constant);
}

template <class Io>
void fields(Io& io, Is<MeasuredCriticalVelocity> auto& measured) {
    std::optional<VelocityEstimate> velocity;
    if (measured.value) velocity = estimate_of(measured);
    Bounds interval{measured.lower, measured.upper};
    io("critical_velocity", velocity, WithoutInterval{});
    io.lenient("interval", interval, Dimension::velocity);
    io("fastest_capture", measured.fastest_capture, Dimension::velocity);
    io("slowest_rebound", measured.slowest_rebound, Dimension::velocity);
    io("transition_width", measured.width, Dimension::velocity);
    io.lenient("note", measured.note);
    if constexpr (Io::reads) {
        if (velocity) measured.value = velocity->value;
        if (velocity) measured.standard_uncertainty = velocity->standard_uncertainty;
        measured.lower = interval.lower;
        measured.upper = interval.upper;
    }
}

Json measured_velocity_json(const MeasuredCriticalVelocity& measured) {
    return to_json(measured, DampingLaw::constant);
}

void fields(auto& io, Is<Influence> auto& influence) {
    io("factor", influence.factor);
    io("first", influence.first.value, NullIfNotFinite{});
    io("first_error", influence.first.standard_error, NullIfNotFinite{});
    io("total", influence.total.value, NullIfNotFinite{});
    io("total_error", influence.total.standard_error, NullIfNotFinite{});
}

void fields(auto& io, Is<CalibrationResponse> auto& response) {
    io.lenient("density", response.density);
    io.lenient("work_of_adhesion", response.work_of_adhesion);
}

void fields(auto& io, Is<VelocityUncertainty> auto& uncertainty) {
    io.derived("method", std::string("Monte Carlo, sobol"));
    io.lenient("evaluations", uncertainty.evaluations);
    io.lenient("undefined", uncertainty.undefined);
    io("mean", uncertainty.mean, Dimension::velocity);
    io("median", uncertainty.median, Dimension::velocity);
    io.lenient("relative_standard_uncertainties", uncertainty.relative);
    io.lenient("taken_as_exact", uncertainty.taken_as_exact);
    io("influences", uncertainty.influences);
    io.unless_empty("powers_of_contact_modulus", uncertainty.response);
    io.unless_empty("damping", uncertainty.damping);
}

void fields(auto& io, Is<ExtrapolatedVelocity> auto& extrapolated) {
    io("critical_velocity", extrapolated.velocity, WithoutInterval{});
    io("interval", extrapolated.velocity.interval, Dimension::velocity);
    io("uncertainty", extrapolated.uncertainty);
    io.unless_empty("check", extrapolated.check);
}

namespace {

/// Sets the interval of a velocity, which is beside it and within it; either may be open where an edit
/// dropped it.
void set_interval(const View& node, VelocityEstimate& velocity) {
    const Bounds within = velocity.interval.value_or(Bounds{});
    velocity.interval = std::nullopt;
    if (const auto beside = node.find("interval"))
        read_value(*beside, velocity.interval.emplace(), Dimension::velocity);
    if (!node.at("critical_velocity").has("interval")) return;
    const Bounds beside = velocity.interval.value_or(Bounds{});
    if (within == beside) return;
    node.at("interval")
        .fail(std::string(within.lower != beside.lower ? "lower" : "upper") +
                  " is not that of the interval in critical_velocity",
              "the same interval in both places");
}

}  // namespace

template <class Io>
void fields(Io& io, Is<LawCriticalVelocity> auto& velocity) {
    io.lenient("detachment", velocity.detachment);
    io.derived("damping_law", io.damping_law());
    io.lenient("damping", velocity.damping, dimension_of(io.damping_law()));
    io("critical_velocity", velocity.velocity);
    io("verdict", velocity.verdict);
    io("contact_time", velocity.contact_time, Dimension::time);
    io("maximum_overlap", velocity.maximum_overlap, Dimension::length);
    io.lenient("crossings", velocity.crossings, Dimension::velocity);
    io("dissipated", velocity.dissipated, Dimension::energy);
    io.lenient("plastic", velocity.plastic, Dimension::energy);
    io("detachment_energy", velocity.detachment_energy, Dimension::energy);
    io("regime", velocity.regime);
    io.unless_empty("interval_note", velocity.interval_note);
    if (velocity.velocity && velocity.velocity->interval)
        io.derived("interval", *velocity.velocity->interval, Dimension::velocity);
    io.unless_empty("uncertainty", velocity.uncertainty);
    io.unless_empty("check", velocity.check);
    if (Io::reads || velocity.from_impacts) io("extrapolated", velocity.extrapolated);
    if constexpr (Io::reads) {
        velocity.from_impacts = velocity.extrapolated.has_value();
        if (velocity.velocity) set_interval(io.node(), *velocity.velocity);
    }
}

Json critical_velocity_json(const LawCriticalVelocity& velocity, DampingLaw law) {
    Json json = to_json(velocity, law);
    if (velocity.velocity) json["critical_velocity"] = value_json(*velocity.velocity, WithoutInterval{});
    return json;
}

void fields(auto& io, Is<SampleCriticalVelocity> auto& sample) {
    io("name", sample.name);
    io("measured", sample.measured);
    io.under_laws(sample.laws, {"name", "measured"});
}

template Json to_json(const CriticalVelocityResult& result, DampingLaw law);
template CriticalVelocityResult from_json(const View& result, DampingLaw law);

}  // namespace ashimpact
