// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "solver/motion/orbit.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

/// Energies of an impact with scaled velocity @p velocity. @param unit of energy [J]
template <class Real>
[[nodiscard]] EnergyLedger energy_ledger(const Orbit<Real>& orbit, const Real& velocity, double unit) {
    const MotionState<Real>& last = orbit.last();
    const Real incident = velocity * velocity / 2;
    const Real remaining = last.velocity * last.velocity / 2;
    const Real spent = last.dissipation + orbit.plastic_work;
    const auto joule = [unit](const Real& energy) { return static_cast<double>(energy) * unit; };
    return {.incident = joule(incident),
            .remaining = joule(remaining),
            .at_touch = joule(orbit.touch_potential),
            .potential = joule(orbit.last_potential),
            .dissipated = joule(last.dissipation),
            .plastic = joule(orbit.plastic_work),
            .jumps = joule(orbit.jumps),
            .residual = joule(incident + orbit.touch_potential - remaining - orbit.last_potential - spent -
                              orbit.jumps),
            .minimum = joule(orbit.rest_potential)};
}

/// What an impact did, in SI units. @param velocity scaled velocity of the impact [1]
/// @param incident velocity of the impact [m/s]
template <class Real>
[[nodiscard]] ImpactResult impact_result(const Orbit<Real>& orbit, const Real& velocity, const Scale& scale,
                                         double incident) {
    const auto seconds = [&](const Real& time) { return static_cast<double>(time) * scale.time(); };
    ImpactResult result{};
    result.outcome = orbit.outcome;
    // Without damping rounding may put it above 1, in a deep well by far more than a last digit.
    result.restitution = std::min(static_cast<double>(orbit.restitution(velocity)), 1.0);
    result.rebound_velocity = result.restitution * incident;
    if (orbit.outcome == Outcome::rebound) result.contact_time = seconds(orbit.end.time);
    if (orbit.turned) result.approach_time = seconds(orbit.turn.time);
    result.maximum_overlap = static_cast<double>(orbit.maximum_overlap) * scale.length;
    result.yielded = orbit.yielded;
    result.energy = energy_ledger(orbit, velocity, scale.energy());
    result.steps = orbit.steps;
    return result;
}

}  // namespace ashimpact
