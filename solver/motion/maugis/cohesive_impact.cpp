// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/maugis/cohesive_impact.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/maugis/transition.hpp"
#include "solver/motion/motion.hpp"

namespace ashimpact {

namespace {

/// The zone of a transition parameter; the last one of each thread is kept, since searches ask for it again.
const CohesiveZone& zone_of(double lambda) {
    thread_local CohesiveZone last(1);
    if (last.lambda() != static_cast<Extended>(lambda)) last = CohesiveZone(lambda);
    return last;
}

EnergyLedger ledger_of(const CohesiveOrbit& followed, const CohesiveMotion& motion, Extended velocity,
                       double unit) {
    const bool rebound = followed.orbit.outcome == Outcome::rebound;
    const MotionState<Extended>& last = rebound ? followed.orbit.end : followed.orbit.turn;
    const Extended incident = velocity * velocity / 2;
    const Extended remaining = last.velocity * last.velocity / 2;
    const Extended outside = motion.potential_outside();
    const Extended potential = rebound ? outside : motion.zone().potential(followed.turn);
    const Extended jumps = followed.lost_at_touch + followed.lost_at_break;
    const auto joule = [unit](Extended energy) { return static_cast<double>(energy) * unit; };
    return {.incident = joule(incident),
            .remaining = joule(remaining),
            .at_touch = joule(outside),
            .potential = joule(potential),
            .dissipated = joule(last.dissipation),
            .plastic = 0.0,
            .jumps = joule(jumps),
            .residual = joule(incident + outside - remaining - potential - last.dissipation - jumps),
            .minimum = joule(motion.zone().potential(motion.zone().equilibrium()))};
}

}  // namespace

ScaledCohesiveImpact scaled_cohesive_impact(const Impact& impact, Precision precision) {
    const double unit = maugis_velocity(impact.contact);
    const Scale scale = Scale::of(impact.contact, unit);
    const ScaledDamping<Extended> damping{impact.damping.law, scale.damping_number(impact.damping)};
    return {scale,
            CohesiveMotion(zone_of(transition_parameter(impact.contact)), damping.polynomial(),
                           impact.detachment, precision),
            static_cast<Extended>(impact.velocity) / static_cast<Extended>(unit)};
}

ImpactResult solve_cohesive_impact(const Impact& impact, Precision precision) {
    const auto [scale, motion, velocity] = scaled_cohesive_impact(impact, precision);
    const CohesiveOrbit followed = follow_cohesive(motion, velocity);
    const Orbit<Extended>& orbit = followed.orbit;
    const bool rebound = orbit.outcome == Outcome::rebound;
    const double unit = scale.time();
    const auto seconds = [&](Extended time) { return static_cast<double>(time) * unit; };
    ImpactResult result{};
    result.outcome = orbit.outcome;
    result.restitution =
        rebound ? std::min(static_cast<double>(std::abs(orbit.end.velocity) / velocity), 1.0) : 0.0;
    result.rebound_velocity = result.restitution * impact.velocity;
    if (rebound) result.contact_time = seconds(orbit.end.time);
    if (orbit.turned) result.approach_time = seconds(orbit.turn.time);
    result.maximum_overlap = static_cast<double>(orbit.maximum_overlap) * scale.length;
    result.energy = ledger_of(followed, motion, velocity, scale.energy());
    result.steps = orbit.steps;
    return result;
}

Extended cohesive_restitution(const Impact& impact, Precision precision) {
    const auto [scale, motion, velocity] = scaled_cohesive_impact(impact, precision);
    const Orbit<Extended> orbit = follow_cohesive(motion, velocity).orbit;
    return orbit.outcome == Outcome::rebound ? std::abs(orbit.end.velocity) / velocity : 0;
}

std::optional<std::string> cohesive_refusal(const ContactPair& contact, Detachment detachment) {
    return cohesive_refusal(zone_of(transition_parameter(contact)), detachment);
}

}  // namespace ashimpact
