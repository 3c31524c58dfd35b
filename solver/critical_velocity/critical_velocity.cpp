// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/critical_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/checks.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/critical_velocity/maugis/cohesive_critical_velocity.hpp"
#include "solver/critical_velocity/plastic_critical_velocity.hpp"
#include "solver/damping/registry.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/motion/velocity_scales.hpp"

namespace ashimpact {

namespace {

/// Verdict known beforehand, or none if the critical orbit has to be followed.
std::optional<CaptureVerdict> known_verdict(const CriticalVelocityProblem& problem, bool adhesive,
                                            bool breaking_costs) {
    const Damping& damping = problem.damping;
    if (problem.detachment == Detachment::zero_force) return CaptureVerdict::never_captured;
    if (damping.coefficient == 0.0 && !breaking_costs) return CaptureVerdict::never_captured;
    return adhesive ? std::nullopt : verdict_without_adhesion(damping, problem.contact);
}

CriticalVelocity finite_result(const Motion<Extended>& motion, const Arrival& arrival,
                               const MotionState<Extended>& turn, const MotionState<Extended>& touch,
                               const Scale& scale) {
    const Extended dissipated = arrival.dissipated_after - touch.dissipation;
    const Extended released = motion.potential(*motion.end) - motion.potential(motion.touch);
    CriticalVelocity result;
    result.value = static_cast<double>(std::sqrt(2 * (dissipated + released))) * scale.velocity;
    result.crossings = {*result.value};
    if (arrival.time_after)
        result.contact_time = static_cast<double>(*arrival.time_after - touch.time) * scale.time();
    result.maximum_overlap = static_cast<double>(motion.overlap(turn.position)) * scale.length;
    result.dissipated = static_cast<double>(dissipated) * scale.energy();
    result.detachment_energy = static_cast<double>(released) * scale.energy();
    return result;
}

CriticalVelocity cohesive_critical_velocity(const CriticalVelocityProblem& problem) {
    const bool costs_nothing = problem.detachment == Detachment::zero_overlap;
    if (problem.damping.coefficient == 0.0 && costs_nothing)
        return {.verdict = CaptureVerdict::never_captured};
    const auto [scale, motion, one] =
        scaled_cohesive_impact({problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    const auto critical = critical_cohesive_impact(motion);
    if (!critical) return {.verdict = CaptureVerdict::always_captured};
    CriticalVelocity result;
    result.value = static_cast<double>(critical->velocity) * scale.velocity;
    result.crossings = {*result.value};
    result.contact_time = static_cast<double>(critical->contact_time) * scale.time();
    result.maximum_overlap = static_cast<double>(critical->maximum_overlap) * scale.length;
    result.dissipated = static_cast<double>(critical->dissipated) * scale.energy();
    result.detachment_energy = static_cast<double>(critical->break_energy) * scale.energy();
    result.steps = critical->steps;
    return result;
}

}  // namespace

std::optional<CaptureVerdict> verdict_without_adhesion(const Damping& damping, const ContactPair& contact) {
    if (damping.coefficient == 0.0) return CaptureVerdict::never_captured;
    using Verdict = std::optional<CaptureVerdict>;
    return RegisteredDampings::visit<Verdict>(damping.law, [&]<class D>() -> Verdict {
        if constexpr (D::shape(0.0) != 0.0) {
            return std::nullopt;
        } else if constexpr (D::overdamped_squared == std::numeric_limits<double>::infinity()) {
            return CaptureVerdict::never_captured;
        } else {
            // Such a law's scaled coefficient is the same at every velocity.
            const Scale any = Scale::of_length(contact, contact.effective_radius);
            const double number = damping.coefficient / D::unit(any);
            return number * number >= D::overdamped_squared ? CaptureVerdict::always_captured
                                                            : CaptureVerdict::never_captured;
        }
    });
}

CriticalVelocity critical_velocity(const CriticalVelocityProblem& problem) {
    validate(Impact{problem.law, problem.detachment, problem.damping, problem.contact, 1.0});
    if (can_yield(problem.law, problem.contact)) return plastic_critical_velocity(problem);
    if (is_cohesive(problem.law, problem.contact)) return cohesive_critical_velocity(problem);
    const double adhesion_velocity = velocity_of_adhesion(problem.law, problem.contact);
    const double unit = std::max({adhesion_velocity, velocity_of_damping(problem.damping, problem.contact),
                                  std::numeric_limits<double>::min()});
    const Scale scale = Scale::of(problem.contact, unit);
    const Motion<Extended> motion = scaled_motion<Extended>(
        {problem.law, problem.detachment, problem.damping, problem.contact, unit}, scale);
    const bool breaking_costs = motion.end && motion.potential(*motion.end) > motion.potential(motion.touch);
    if (const auto verdict = known_verdict(problem, adhesion_velocity > 0.0, breaking_costs)) {
        return {.verdict = *verdict};
    }
    if (problem.damping.coefficient > 0.0)  // beyond the range of numbers there is no verdict to be had
        require_positive("the velocity that this damping captures", unit, Dimension::velocity);
    const std::optional<Arrival> arrival = critical_arrival(motion);
    if (!arrival) return {.verdict = CaptureVerdict::never_captured};
    int steps = 0;
    const auto turn = back_to_turn(motion, arrival->state, steps);
    if (!turn) return {.verdict = CaptureVerdict::always_captured};
    const MotionState<Extended> touch = back_to(motion, *turn, motion.touch, steps);
    CriticalVelocity result = finite_result(motion, *arrival, *turn, touch, scale);
    result.steps = steps;
    return result;
}

}  // namespace ashimpact
