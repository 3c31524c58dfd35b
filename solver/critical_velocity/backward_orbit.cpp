// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/backward_orbit.hpp"

#include <cmath>

#include "solver/critical_velocity/rest_point.hpp"

namespace ashimpact {

namespace {

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

CriticalImpact critical_impact(const Arrival& arrival, const MotionState<Extended>& touch, Extended plastic,
                               Extended break_energy, Extended maximum_overlap) {
    CriticalImpact impact{.dissipated = arrival.dissipated_after - touch.dissipation,
                          .plastic = plastic,
                          .break_energy = break_energy,
                          .contact_time = std::nullopt,
                          .maximum_overlap = maximum_overlap};
    impact.velocity = std::sqrt(2 * (impact.dissipated + plastic + break_energy));
    if (arrival.time_after) impact.contact_time = *arrival.time_after - touch.time;
    return impact;
}

CriticalImpacts critical_impacts(const Motion<Extended>& motion) {
    const std::optional<Arrival> arrival = critical_arrival(motion);
    if (!arrival) return {.verdict = CaptureVerdict::never_captured};
    const auto turn = back_to_turn(motion, arrival->state, motion.equilibrium);
    if (!turn) return {.verdict = CaptureVerdict::always_captured};
    return {.impacts = {critical_impact(*arrival, back_to(motion, *turn, motion.touch), 0,
                                        motion.potential(*motion.end) - motion.potential(motion.touch),
                                        motion.overlap(turn->position))}};
}

}  // namespace ashimpact
