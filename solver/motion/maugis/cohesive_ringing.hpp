// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/maugis/cohesive_orbit.hpp"

namespace ashimpact {

/// Follows the ringing of a captured particle from the state in which capture became certain, across the gap
/// and back where the motion leads there, until the energy left is that of 1 % of @p velocity or @p most
/// Taylor steps are taken. @p observe as in CohesiveFollower.
template <class Observer>
void ring(const CohesiveMotion& motion, const CohesiveOrbit& captured, Extended velocity, std::size_t most,
          Observer& observe) {
    const CohesiveZone& zone = motion.zone();
    const CohesiveState join = zone.join();
    const Extended rest = zone.potential(zone.equilibrium());
    const Extended enough = 0.5e-4_ext * velocity * velocity;  // 1 % of the velocity
    MotionState<Extended> state = captured.orbit.end;
    bool touching = captured.end.touching();
    const auto energy = [&] {
        const Extended potential =
            touching ? motion.touching().potential(state.position) : motion.gap().potential(state.position);
        return state.velocity * state.velocity / 2 + potential - rest;
    };
    const auto step = [&](const auto& branch, Extended edge, Extended direction) {
        const MotionExpansion<Extended> x = branch.expand(state);
        const auto left = event_within(
            x, x.step, [&](const MotionState<Extended>& s) { return direction * (edge - s.position); });
        const Extended used = left.value_or(x.step);
        observe(branch, x, used);
        state = x.at(used);
        return left.has_value();
    };
    for (std::size_t i = 0; i < most && energy() > enough; ++i) {
        if (touching && step(motion.touching(), motion.touching().coordinate(join), -1)) {
            touching = false;
            state.position = GapBranch::coordinate(join);
        } else if (!touching && step(motion.gap(), GapBranch::coordinate(join), 1)) {
            touching = true;
            state.position = motion.touching().coordinate(join);
        }
    }
}

}  // namespace ashimpact
