#include "solver/backward_orbit.hpp"

#include "materials/error.hpp"
#include "solver/orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ashimpact {

namespace {

/// Beyond this coordinate, in units of the equilibrium or of the damping length, a backward orbit has
/// escaped: no velocity is high enough to rebound.
constexpr Extended escape = 1e25L;

/// Work of damping over the last stretch [0, x] before the end at speed sqrt(2 (U_end - U)): three-point
/// Gauss in x^(1/2), in which the integrand of every law is smooth.
Extended last_dissipation(const Polynomial<Extended>& fall, const Polynomial<Extended>& drag, Extended x) {
    constexpr std::array<Extended, 3> node{0.112701665379258311482L, 0.5L, 0.887298334620741688518L};
    constexpr std::array<Extended, 3> weight{5.0L / 18, 8.0L / 18, 5.0L / 18};
    Extended sum = 0;
    for (std::size_t i = 0; i < node.size(); ++i) {
        const Extended at = x * node[i] * node[i];
        sum += weight[i] * 2 * node[i] * x * drag(at) * std::sqrt(std::max(0.0L, 2 * fall(at)));
    }
    return sum;
}

/// The end of contact is a rest point of the regularised motion: the critical orbit leaves it backward along
/// v^2/2 = U_end - U(q) + (work of damping up to the end), so near it that damping hardly matters.
Arrival at_rest_point(const Motion<Extended>& motion) {
    const Extended end = *motion.end;
    const Polynomial<Extended> rise = motion.potential.shifted(end);
    const Polynomial<Extended> drag = motion.drag.shifted(end);
    Polynomial<Extended> fall = Extended(-1) * rise;
    fall[0] = 0;  // U_end - U at the end itself
    fall[1] = 0;  // delta' = 0 there
    Extended x = 1e-4L * (motion.equilibrium - end);
    Extended dissipated = last_dissipation(fall, drag, x);
    while (dissipated > 1e-4L * fall(x)) {
        x /= 8;
        dissipated = last_dissipation(fall, drag, x);
    }
    Arrival arrival;
    arrival.state.position = end + x;
    arrival.state.velocity = -std::sqrt(2 * (fall(x) + dissipated));
    arrival.dissipated_after = dissipated;
    return arrival;
}

/// Hertz with constant damping beta: the critical orbit arrives along v = -beta x + (2/(3 beta)) F(x), where
/// x is the overlap beyond the end.
Arrival at_damped_end(const Motion<Extended>& motion) {
    const Extended beta = motion.damping[0];
    const int power = motion.overlap.degree;
    const Extended x = 1e-12L * std::pow(beta, 4.0L);
    Arrival arrival;
    arrival.state.position = std::pow(x / motion.overlap[power], 1.0L / static_cast<Extended>(power));
    arrival.state.velocity = -beta * x + 2 / (3 * beta) * motion.force(arrival.state.position);
    arrival.dissipated_after = beta * beta * x * x / 2;
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
    return std::abs(motion.slope(*motion.end)) < 1e-12L;
}

std::optional<Arrival> critical_arrival(const Motion<Extended>& motion) {
    const bool adhesive = motion.equilibrium > *motion.end;
    if (adhesive && ends_at_rest_point(motion)) return at_rest_point(motion);
    if (adhesive) return Arrival{.state = {.position = *motion.end}};
    const bool constant = motion.damping.degree == 0 && motion.damping[0] > 0;
    if (constant) return at_damped_end(motion);
    return std::nullopt;
}

std::optional<MotionState<Extended>> back_to_turn(const Motion<Extended>& motion, MotionState<Extended> state,
                                                  int& steps) {
    const MotionStepper<Extended> stepper(motion);
    const Extended farthest = escape * std::max({1.0L, motion.equilibrium, state.position});
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
