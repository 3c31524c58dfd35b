// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/critical_velocity/backward_orbit.hpp"

namespace ashimpact {

namespace {

using Terms = Series<Extended>;

/// The critical orbit near the fold of the touching branch, where delta'(q) = 0: v is a power series of
/// x = q - q_fold with v dv/dx = -delta' (eta v + F), the root that arrives (v < 0 for x > 0).
class FoldArrival {
  public:
    FoldArrival(const TouchingBranch& branch, Extended fold) : statics_(branch.statics(fold)) {
        statics_.slope[0] = 0;
        // v_1^2 = -delta''(fold) F(fold)
        velocity_[1] = -std::sqrt(-statics_.slope[1] * statics_.force[0]);
        total_[0] = statics_.force[0];
        for (std::size_t n = 2; n < velocity_.size(); ++n) {
            total_[n - 1] = statics_.force[n - 1] + product_coefficient(statics_.damping, velocity_, n - 1);
            Extended rest = -product_coefficient(statics_.slope, total_, n);  // total_[n] meets slope[0] = 0
            for (std::size_t i = 2; i < n; ++i)
                rest -= static_cast<Extended>(n + 1) / 2 * velocity_[i] * velocity_[n + 1 - i];
            velocity_[n] = rest / (static_cast<Extended>(n + 1) * velocity_[1]);
        }
    }

    /// The orbit where its series still hold to rounding.
    [[nodiscard]] Arrival arrival(Extended fold) const {
        const Extended e = std::numbers::e_v<Extended>;
        const Extended x = convergence() / (e * e);
        Arrival arrival;
        arrival.state.position = fold + x;
        arrival.state.velocity = value(velocity_, x);
        // From x to the fold: work of eta v over d(delta), time of d(delta)/v.
        Terms work{};
        Terms pace{};
        for (std::size_t n = 0; n + 1 < velocity_.size(); ++n) {
            Terms drag{};
            for (std::size_t i = 0; i <= n; ++i)
                drag[i] = product_coefficient(statics_.damping, velocity_, i);
            work[n + 1] = -product_coefficient(drag, statics_.slope, n) / static_cast<Extended>(n + 1);
        }
        Terms quotient{};  // delta'/v, both without their leading power
        for (std::size_t n = 0; n + 1 < velocity_.size(); ++n) {
            Extended rest = statics_.slope[n + 1];
            for (std::size_t k = 0; k < n; ++k) rest -= quotient[k] * velocity_[n - k + 1];
            quotient[n] = rest / velocity_[1];
            pace[n + 1] = -quotient[n] / static_cast<Extended>(n + 1);
        }
        arrival.dissipated_after = value(work, x);
        arrival.time_after = value(pace, x);
        return arrival;
    }

  private:
    [[nodiscard]] Extended convergence() const {
        Terms pace{};  // without the leading zero, which has no bearing on the radius
        std::copy(velocity_.begin() + 1, velocity_.end(), pace.begin());
        pace.back() = velocity_.back() / radius(statics_.slope);
        return std::min({radius(pace), radius(statics_.slope), radius(statics_.force)});
    }

    TouchingBranch::Statics statics_;
    Terms velocity_{};
    Terms total_{};
};

/// Time that the critical orbit takes from cohesive radius @p c to rest at the fold of the gap branch, c_f:
/// with U(c_f) - U(c) = (pi lambda/8) (c - c_f)^2 (c^2 + 2 c c_f/3 + c_f^2/3) the integral of delta'(c)/v is
/// an arsinh.
Extended gap_time_to_rest(const CohesiveZone& zone, Extended c) {
    const Extended fold = zone.pull_off().cohesive_radius;
    const auto primitive = [&](Extended x) {
        return std::asinh((3 * x + fold) / (std::numbers::sqrt2_v<Extended> * fold));
    };
    return (primitive(c) - primitive(fold)) / std::sqrt(std::numbers::pi_v<Extended> * zone.lambda() / 4);
}

/// The orbit just before the end of contact, on the touching branch.
Arrival arrival_of(const CohesiveMotion& motion) {
    const TouchingBranch& branch = motion.touching();
    const CohesiveState& end = motion.end();
    if (!end.touching()) {
        const CohesiveState join = motion.zone().join();
        const Extended fall = motion.potential_at_end() - motion.zone().potential(join);
        return {.state = {.position = branch.coordinate(join), .velocity = -std::sqrt(2 * fall)},
                .time_after = gap_time_to_rest(motion.zone(), join.cohesive_radius)};
    }
    const Extended place = branch.coordinate(end);
    if (end.angle == motion.zone().pull_off().angle) return FoldArrival(branch, place).arrival(place);
    return {.state = {.position = place}};
}

}  // namespace

CriticalImpacts critical_impacts(const CohesiveMotion& motion) {
    const TouchingBranch& branch = motion.touching();
    const Arrival arrival = arrival_of(motion);
    const auto turn = back_to_turn(branch, arrival.state, motion.rest().position);
    if (!turn) return {.verdict = CaptureVerdict::always_captured};
    const bool begins_in_gap = !motion.begin().touching();
    const CohesiveState first = begins_in_gap ? motion.zone().join() : motion.begin();
    MotionState<Extended> state = back_to(branch, *turn, branch.coordinate(first));
    if (begins_in_gap) {
        state.position = first.cohesive_radius;
        state = back_to(motion.gap(), state, motion.begin().cohesive_radius);
    }
    return {.impacts = {critical_impact(arrival, state, 0,
                                        motion.potential_at_end() - motion.potential_at_begin(),
                                        branch.overlap(turn->position))}};
}

}  // namespace ashimpact
