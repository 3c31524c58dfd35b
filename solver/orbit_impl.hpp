#pragma once

#include "materials/error.hpp"
#include "solver/orbit.hpp"

#include <cmath>

namespace ashimpact {

inline constexpr int most_steps = 20000;

/// Overlap and velocity, scaled, below which a rebound has come to nothing: no instrument tells it from a
/// capture, and its powers would underflow.
inline constexpr double vanishing_overlap = 1e-100;

template <class Real>
CaptureTest<Real>::CaptureTest(const Motion<Real>& motion)
    : motion_(motion), by_place_(motion.end.has_value()) {
    const Real q = motion.equilibrium;
    always_overdamped_ = motion.touch == Real(0) && !motion.squared && motion.damping.degree == 1 &&
                         motion.damping[1] * motion.damping[1] >= Real(5);
    end_overlap_ = by_place_ ? motion.overlap(*motion.end) : Real(0);
    end_potential_ = by_place_ ? motion.potential(*motion.end) : Real(0);
    equilibrium_overlap_ = motion.overlap(q);
    force_slope_ = motion.force.derivative();
    least_damping_ = motion.damping(q);
}

template <class Real>
bool CaptureTest<Real>::bound(const MotionState<Real>& state) const {
    const Real energy = state.velocity * state.velocity / Real(2) + motion_.potential(state.position);
    return by_place_ && energy < end_potential_;
}

template <class Real>
bool CaptureTest<Real>::creeping(const MotionState<Real>& state) const {
    if (!by_place_) return false;
    if (always_overdamped_) return true;
    if (state.position < motion_.equilibrium) return false;
    const Real way = motion_.overlap(state.position) - end_overlap_;
    if (way < vanishing_overlap && state.velocity > -vanishing_overlap) return true;
    // Below the line v = -(eta/2)(delta - delta_end) the motion cannot get while F <= (eta^2/4)(delta -
    // delta_end).
    return state.velocity >= -least_damping_ / Real(2) * way &&
           Real(4) * motion_.force(state.position) < least_damping_ * least_damping_ * way;
}

template <class Real>
bool CaptureTest<Real>::creeping_up(const MotionState<Real>& state) const {
    if (state.position >= motion_.equilibrium) return false;
    const Real damping = motion_.damping(state.position);
    const Real way = equilibrium_overlap_ - motion_.overlap(state.position);
    // A spiral so tight that it turns beneath rounding only looks like this one.
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * equilibrium_overlap_;
    if (std::abs(way) <= rounding && state.velocity <= damping * rounding) return true;
    if (state.velocity > damping / Real(2) * way) return false;
    // Below the line v = (eta/2)(delta_eq - delta) it stays where dF/d(delta) <= eta^2/4 all the way.
    const Polynomial<Real> excess = force_slope_ - damping * damping / Real(4) * motion_.slope;
    return excess.upper_bound(state.position, motion_.equilibrium) <= Real(0);
}

/// Pseudo-time within [0, limit] at which @p event falls through zero, or none; it must be positive at first.
template <class Real, class Event>
[[nodiscard]] std::optional<Real> event_within(const MotionExpansion<Real>& x, Real limit, Event&& event) {
    const auto along = [&](Real h) { return event(x.at(h)); };
    if (along(limit) > Real(0)) return std::nullopt;
    return sign_change<Real>(along, limit);
}

/// Where the outward motion stops within the step, or the whole step: beyond it the particle comes back.
template <class Real>
[[nodiscard]] Real outward_part(const MotionExpansion<Real>& x) {
    const auto inward = event_within(x, x.step, [](const MotionState<Real>& s) { return -s.velocity; });
    return inward.value_or(x.step);
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

template <class Real, class Observer>
ApproachEnd approach(const Motion<Real>& motion, MotionState<Real>& state,
                     const std::optional<Real>& leave_at, Orbit<Real>& orbit, Observer& observe) {
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
        const Real outward = outward_part(x);
        const auto end = event_within(x, outward, remaining);
        const Real used = end.value_or(outward);
        observe(motion, x, used);
        state = x.at(used);
        if (end) {
            orbit.outcome = Outcome::rebound;
            break;
        }
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
