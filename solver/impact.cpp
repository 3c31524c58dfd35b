#include "solver/impact.hpp"

#include "materials/error.hpp"
#include "solver/orbit.hpp"
#include "solver/scaled_impact.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ashimpact {

namespace {

void require_positive(double value, std::string_view quantity, std::string_view unit) {
    if (std::isfinite(value) && value > 0.0) return;
    std::ostringstream problem;
    problem << quantity << " is " << value << ' ' << unit;
    throw InputError(problem.str(), "a finite number > 0 " + std::string(unit));
}

void require_not_negative(double value, std::string_view quantity, std::string_view unit) {
    if (std::isfinite(value) && value >= 0.0) return;
    std::ostringstream problem;
    problem << quantity << " is " << value << ' ' << unit;
    throw InputError(problem.str(), "a finite number >= 0 " + std::string(unit));
}

EnergyLedger ledger_of(const Motion<Extended>& motion, const Orbit<Extended>& orbit, double unit) {
    const MotionState<Extended>& last = orbit.outcome == Outcome::rebound ? orbit.end : orbit.turn;
    const Extended incident = 0.5L;  // the scale's velocity is v_in
    const Extended remaining = last.velocity * last.velocity / 2;
    const Extended at_touch = motion.potential(motion.touch);
    const Extended potential = motion.potential(last.position);
    const auto joule = [unit](Extended energy) { return static_cast<double>(energy) * unit; };
    return {.incident = joule(incident),
            .remaining = joule(remaining),
            .at_touch = joule(at_touch),
            .potential = joule(potential),
            .dissipated = joule(last.dissipation),
            .residual = joule(incident + at_touch - remaining - potential - last.dissipation),
            .minimum = joule(motion.potential(motion.equilibrium))};
}

}  // namespace

std::string_view name_of(Outcome outcome) {
    return outcome == Outcome::rebound ? "rebound" : "capture";
}

std::optional<std::string> refusal(Law law, Detachment detachment) {
    return law.visit<std::optional<std::string>>([&]<template <class> class L>()
                                                     -> std::optional<std::string> {
        const L<Extended> numeric{1.0L};  // whether it is admissible depends on no number
        const auto point = numeric.detachment_point(detachment);
        const std::string subject =
            std::string(name_of(detachment)) + " does not end a contact of law " + std::string(law.name());
        if (!point) return subject + ": the law has no such point apart from zero overlap";
        const Motion<Extended> motion =
            make_motion<L, Extended>(numeric.adhesion, DampingLaw::constant, 0.0L, detachment);
        if (motion.potential(*motion.end) < motion.potential(motion.touch)) {
            return subject +
                   ": its potential there is below that at first touch, an undamped impact would gain energy";
        }
        return std::nullopt;
    });
}

std::string admissible_detachments(Law law) {
    std::string names;
    for (const DetachmentName& entry : detachment_names) {
        if (refusal(law, entry.detachment)) continue;
        if (!names.empty()) names += ", ";
        names += entry.name;
    }
    return names;
}

void validate(const ContactPair& contact) {
    require_positive(contact.mass, "mass", "kg");
    require_positive(contact.effective_radius, "effective_radius", "m");
    require_positive(contact.contact_modulus, "contact_modulus", "Pa");
    require_not_negative(contact.work_of_adhesion, "work_of_adhesion", "J/m2");
}

void validate(const Impact& impact) {
    validate(impact.contact);
    require_positive(impact.velocity, "velocity", "m/s");
    require_not_negative(impact.damping.coefficient, "damping", unit_of(impact.damping.law));
    if (const auto reason = refusal(impact.law, impact.detachment)) {
        throw InputError(*reason, admissible_detachments(impact.law));
    }
}

ImpactResult solve_impact(const Impact& impact) {
    validate(impact);
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const Motion<Extended> motion = scaled_motion<Extended>(impact, scale);
    const Orbit<Extended> orbit = follow<Extended>(motion, 1.0L);

    const bool rebound = orbit.outcome == Outcome::rebound;
    const auto seconds = [&](Extended time) { return static_cast<double>(time) * scale.time(); };
    ImpactResult result{};
    result.outcome = orbit.outcome;
    result.restitution = rebound ? static_cast<double>(std::abs(orbit.end.velocity)) : 0.0;
    result.rebound_velocity = result.restitution * impact.velocity;
    if (rebound) result.contact_time = seconds(orbit.end.time);
    if (orbit.turned) result.approach_time = seconds(orbit.turn.time);
    result.maximum_overlap = static_cast<double>(orbit.maximum_overlap) * scale.length;
    result.energy = ledger_of(motion, orbit, scale.energy());
    result.steps = orbit.steps;
    return result;
}

double restitution_of(const Impact& impact) {
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const Orbit<double> orbit = follow<double>(scaled_motion<double>(impact, scale), 1.0);
    return orbit.outcome == Outcome::rebound ? std::abs(orbit.end.velocity) : 0.0;
}

}  // namespace ashimpact
