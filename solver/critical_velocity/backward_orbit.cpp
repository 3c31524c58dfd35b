// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/backward_orbit.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solver/critical_velocity/rest_point.hpp"
#include "solver/motion/orbit.hpp"

namespace ashimpact {

namespace {

/// Beyond this coordinate, in units of the equilibrium or of the damping length, a backward orbit has
/// escaped: no velocity is high enough to rebound.
constexpr Extended escape = 1e25_ext;

/// Hertz with constant damping beta: the critical orbit arrives along v = -beta x + (2/(3 beta)) F(x), where
/// x is the overlap beyond the end; slower and slower, it never gets there.
Arrival at_damped_end(const Motion<Extended>& motion) {
    const Extended beta = motion.damping[0];
    const int power = motion.overlap.degree;
    const Extended x = 1e-12_ext * std::pow(beta, 4.0_ext);
    Arrival arrival;
    arrival.state.position = std::pow(x / motion.overlap[power], 1.0_ext / static_cast<Extended>(power));
    arrival.state.velocity = -beta * x + 2 / (3 * beta) * motion.force(arrival.state.position);
    arrival.dissipated_after = beta * beta * x * x / 2;
    arrival.time_after = std::nullopt;
    return arrival;
}

/// Expands backward, counting the steps of this orbit in @p own and of all in @p total.
MotionExpansion<Extended> backward_expansion(const MotionStepper<Extended>& stepper,
                                             const MotionState<Extended>& state, int& own, int& total) {
    MotionExpansion<Extended> x = counted_expansion(stepper, state, own);
    x.step = -x.step;
    ++total;
    return x;
}

}  // namespace

bool ends_at_rest_point(const Motion<Extended>& motion) {
    return std::abs(motion.slope(*motion.end)) <= 1e-12_ext * std::abs(motion.slope(motion.equilibrium));
}

std::optional<Arrival> critical_arrival(const Motion<Extended>& motion) {
    const bool adhesive = motion.equilibrium > *motion.end;
    if (adhesive && ends_at_rest_point(motion)) return arrival_at_rest_point(motion);
    if (adhesive) return Arrival{.state = {.position = *motion.end}};
    if (!(motion.damping[0] > 0)) return std::nullopt;
    return motion.damping.degree == 0 ? at_damped_end(motion) : arrival_at_rest_point(motion);
}

std::optional<MotionState<Extended>> back_to_turn(const Motion<Extended>& motion, MotionState<Extended> state,
                                                  int& steps) {
    const MotionStepper<Extended> stepper(motion);
    const Extended farthest = escape * std::max({1.0_ext, motion.equilibrium, state.position});
    int own = 0;
    while (state.position < farthest) {
        const MotionExpansion<Extended> x = backward_expansion(stepper, state, own, steps);
        const auto turn = event_within(x, x.step, [](const MotionState<Extended>& s) { return -s.velocity; });
        state = x.at(turn.value_or(x.step));
        if (turn) {
            state.velocity = 0;
            return state;
        }
    }
    return std::nullopt;
}

MotionState<Extended> back_to(const Motion<Extended>& motion, MotionState<Extended> state, Extended target,
                              int& steps) {
    const MotionStepper<Extended> stepper(motion);
    int own = 0;
    while (true) {
        const MotionExpansion<Extended> x = backward_expansion(stepper, state, own, steps);
        const auto rest = event_within(x, x.step, [](const MotionState<Extended>& s) { return s.velocity; });
        const Extended part = rest.value_or(x.step);
        const auto there =
            event_within(x, part, [&](const MotionState<Extended>& s) { return s.position - target; });
        state = x.at(there.value_or(part));
        // The energy suffices to get there, so rest just before it is rounding.
        if (there || rest) return state;
    }
}

}  // namespace ashimpact
