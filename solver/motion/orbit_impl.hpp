// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.hpp"
#include "solver/motion/capture_impl.hpp"
#include "solver/motion/orbit.hpp"

namespace ashimpact {

inline constexpr int most_steps = 20000;

/// Pseudo-time within [0, limit] at which @p event falls through zero, or none; it must be positive at first.
template <class Real, class Event>
[[nodiscard]] std::optional<Real> event_within(const MotionExpansion<Real>& x, Real limit, Event&& event) {
    const auto along = [&](Real h) { return event(x.at(h)); };
    if (along(limit) > Real(0)) return std::nullopt;
    return sign_change<Real>(along, limit);
}

/// Where the outward motion stops within the step: beyond it the particle comes back.
template <class Real>
[[nodiscard]] std::optional<Real> turning_back(const MotionExpansion<Real>& x) {
    return event_within(x, x.step, [](const MotionState<Real>& s) { return -s.velocity; });
}

template <class Real>
[[nodiscard]] MotionExpansion<Real> counted_expansion(const MotionStepper<Real>& stepper,
                                                      const MotionState<Real>& state, int& steps) {
    if (++steps > most_steps) throw ConvergenceError("impact did not end within the step limit");
    return stepper.expand(state);
}

/// The state that a creeping approach tends to: damping takes all the energy there is above equilibrium.
template <class Real>
[[nodiscard]] MotionState<Real> at_rest_in_equilibrium(const Motion<Real>& motion,
                                                       const MotionState<Real>& state) {
    const Real excess = state.velocity * state.velocity / Real(2) + motion.potential(state.position) -
                        motion.potential(motion.equilibrium);
    return {.position = motion.equilibrium,
            .velocity = Real(0),
            .time = state.time,
            .dissipation = state.dissipation + excess};
}

template <class Real, class Observer, class Beyond>
ApproachEnd approach(const Motion<Real>& motion, MotionState<Real>& state,
                     const std::optional<Real>& leave_at, Orbit<Real>& orbit, Observer& observe,
                     const Beyond& creeps_beyond) {
    const MotionStepper<Real> stepper(motion);
    const CaptureTest<Real> capture(motion);
    while (true) {
        const MotionExpansion<Real> x = counted_expansion(stepper, state, orbit.steps);
        const auto turn = event_within(x, x.step, [](const MotionState<Real>& s) { return s.velocity; });
        Real used = turn.value_or(x.step);
        const auto to_go = [&](const MotionState<Real>& s) { return *leave_at - s.position; };
        const auto leave = leave_at ? event_within(x, used, to_go) : std::nullopt;
        used = leave.value_or(used);
        observe(motion, x, used);
        state = x.at(used);
        if (leave) return ApproachEnd::left;
        if (turn) {
            state.velocity = Real(0);
            orbit.turned = true;
            orbit.turn = orbit.end = state;
            orbit.maximum_overlap = motion.overlap(state.position);
            return ApproachEnd::turned;
        }
        const bool leaves_first = leave_at && *leave_at < motion.equilibrium;
        if (leaves_first && creeps_beyond(state)) {
            orbit.end = state;
            return ApproachEnd::passing;
        }
        if (!leaves_first && capture.creeping_up(state)) {
            orbit.end = state;
            orbit.turn = at_rest_in_equilibrium(motion, state);
            orbit.maximum_overlap = motion.overlap(motion.equilibrium);
            return ApproachEnd::creeping;
        }
    }
}

template <class Real, class Observer>
void rebound(const Motion<Real>& motion, MotionState<Real> state, Orbit<Real>& orbit, Observer& observe) {
    const MotionStepper<Real> stepper(motion);
    const CaptureTest<Real> capture(motion);
    const auto remaining = [&](const MotionState<Real>& s) -> Real {
        if (motion.end) return s.position - *motion.end;
        if (s.position <= motion.touch) return Real(-1);  // the total force fell through zero before
        return motion.force(s.position) + motion.damping(s.position) * s.velocity;
    };
    while (!capture.bound(state) && !capture.creeping(state)) {
        const MotionExpansion<Real> x = counted_expansion(stepper, state, orbit.steps);
        const auto inward = turning_back(x);
        const Real outward = inward.value_or(x.step);
        const auto end = event_within(x, outward, remaining);
        const Real used = end.value_or(outward);
        observe(motion, x, used);
        state = x.at(used);
        if (end) {
            orbit.outcome = Outcome::rebound;
            break;
        }
        if (inward) break;  // bound, even where rounding leaves it the energy to reach the end
    }
    orbit.end = state;
}

template <class Real, class Observer>
Orbit<Real> follow(const Motion<Real>& motion, Real velocity, Observer&& observe) {
    Orbit<Real> orbit;
    MotionState<Real> state{.position = motion.touch, .velocity = velocity};
    if (approach<Real>(motion, state, std::nullopt, orbit, observe) == ApproachEnd::turned) {
        rebound(motion, state, orbit, observe);
    }
    return orbit;
}

}  // namespace ashimpact
