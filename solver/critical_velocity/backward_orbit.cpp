// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/backward_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ashimpact {

namespace {

using Terms = Series<Extended>;

/// Coefficient of z^power in p(z^2).
Extended coefficient(const Polynomial<Extended>& p, int power) {
    const bool present = power >= 0 && power % 2 == 0 && power / 2 <= p.degree;
    return present ? p[power / 2] : 0;
}

/// Lowest power of x in p(x); the degree if p is 0.
int lowest_power(const Polynomial<Extended>& p) {
    int power = 0;
    while (p[power] == 0 && power < p.degree) ++power;
    return power;
}

/// Integral of z^leading (c_0 + c_1 z + ...) from 0 to @p z.
Extended integral(const Terms& terms, int leading, Extended z) {
    Terms integrated = terms;
    for (std::size_t n = 0; n < terms.size(); ++n)
        integrated[n] /= static_cast<Extended>(leading + 1 + static_cast<int>(n));
    return value(integrated, z) * std::pow(z, static_cast<Extended>(leading + 1));
}

/// The critical orbit just before an end of contact that is a rest point of the regularised motion
/// (delta'(q_end) = 0: zero overlap of DMT, Brach-Dunn and sjkr, the pull-off fold of JKR).
///
/// With z = sqrt(q - q_end) and the speed v it leaves backward along
///
///     v^2/2 = U_end - U + integral of 2 z delta' eta v dz,
///
/// whose solution is a power series in z for every law. Damping may be of the leading order, as in sjkr,
/// whose attraction vanishes as the overlap does. The series gives, each to rounding, the speed, and from it
/// the work of damping and the time up to the end. The time is the integral of 2 z delta'/v dz, none if it
/// diverges.
class RestPoint {
  public:
    explicit RestPoint(const Motion<Extended>& motion)
        : fall_(Extended(-1) * motion.potential.shifted(*motion.end)),
          slope_(motion.slope.shifted(*motion.end)),
          drag_(motion.drag.shifted(*motion.end)) {
        fall_[0] = 0;                         // U_end - U at the end itself
        fall_[1] = slope_[0] = drag_[0] = 0;  // delta' = 0 there
        order_ = leading_power();
        expand_speed();
        expand_time();
    }

    /// The orbit where its series still hold to rounding.
    [[nodiscard]] Arrival arrival(Extended end) const {
        const Extended z = radius(speed_) / (std::numbers::e_v<Extended> * std::numbers::e_v<Extended>);
        Arrival arrival;
        arrival.state.position = end + z * z;
        arrival.state.velocity = -std::pow(z, static_cast<Extended>(order_)) * value(speed_, z);
        arrival.dissipated_after = integral(work_, order_ + 1 + 2 * lowest_power(drag_), z);
        // The time is infinite if the speed vanishes as the overlap does, or faster.
        if (time_order() < 0)
            arrival.time_after = std::nullopt;
        else
            arrival.time_after = integral(pace_, time_order(), z);
        return arrival;
    }

  private:
    [[nodiscard]] int time_order() const { return 1 + 2 * lowest_power(slope_) - order_; }

    /// Leading power of the speed v in z. In the energy equation U_end - U goes as z^(2 l), the work of
    /// damping at a speed z^p as z^(p + 2 + 2 g), if U_end - U is led by q^l and delta' eta by q^g.
    [[nodiscard]] int leading_power() const {
        const int by_force = lowest_power(fall_);
        const bool damped = drag_[lowest_power(drag_)] != 0;
        return damped ? std::min(by_force, 2 + 2 * lowest_power(drag_)) : by_force;
    }

    /// v = z^order (c_0 + c_1 z + ...) from the energy equation, term by term. If damping is of the leading
    /// order too, c_0 solves c_0^2 = 2 f + 2 d c_0, and each c_n is on both sides.
    void expand_speed() {
        const Extended drag = coefficient(drag_, order_ - 2);
        const Extended damped = drag / static_cast<Extended>(order_);
        speed_[0] = drag == 0 ? std::sqrt(2 * fall_[order_])
                              : damped + std::sqrt(damped * damped + 2 * fall_[order_]);
        for (std::size_t n = 1; n < speed_.size(); ++n) {
            const int power = static_cast<int>(n) + 2 * order_;
            Extended square = 2 * coefficient(fall_, power);
            for (int j = 0; j < static_cast<int>(n); ++j) {
                square += 4 * coefficient(drag_, power - 2 - order_ - j) *
                          speed_[static_cast<std::size_t>(j)] / static_cast<Extended>(power);
            }
            for (std::size_t i = 1; i < n; ++i) square -= speed_[i] * speed_[n - i];
            speed_[n] = square / (2 * speed_[0] - 4 * drag / static_cast<Extended>(power));
        }
    }

    /// Work of damping and time over dz: 2 z delta' eta v and 2 z delta'/v, without their leading powers.
    void expand_time() {
        const int slope_power = 2 * lowest_power(slope_);
        const int drag_power = 2 * lowest_power(drag_);
        for (std::size_t n = 0; n < speed_.size(); ++n) {
            Extended pace = 2 * coefficient(slope_, slope_power + static_cast<int>(n));
            for (std::size_t i = 0; i < n; ++i) {
                pace -= pace_[i] * speed_[n - i];
                work_[n] += 2 * coefficient(drag_, drag_power + static_cast<int>(n - i)) * speed_[i];
            }
            pace_[n] = pace / speed_[0];
            work_[n] += 2 * coefficient(drag_, drag_power) * speed_[n];
        }
    }

    Polynomial<Extended> fall_;   ///< U_end - U
    Polynomial<Extended> slope_;  ///< delta'
    Polynomial<Extended> drag_;   ///< delta' eta
    int order_ = 0;               ///< leading power of the speed in z
    Terms speed_{};
    Terms work_{};
    Terms pace_{};
};

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

/// Whether the end of contact is a rest point of the regularised motion.
bool ends_at_rest_point(const Motion<Extended>& motion) {
    return std::abs(motion.slope(*motion.end)) <= 1e-12_ext * std::abs(motion.slope(motion.equilibrium));
}

}  // namespace

std::optional<Arrival> critical_arrival(const Motion<Extended>& motion) {
    const bool adhesive = motion.equilibrium > *motion.end;
    if (adhesive && ends_at_rest_point(motion)) return RestPoint(motion).arrival(*motion.end);
    if (adhesive) return Arrival{.state = {.position = *motion.end}};
    if (!(motion.damping[0] > 0)) return std::nullopt;
    return motion.damping.degree == 0 ? at_damped_end(motion) : RestPoint(motion).arrival(*motion.end);
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
