// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ZONE_STEPS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ZONE_STEPS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ZONE_STEPS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ZONE_STEPS_INL_HPP
#endif

#include <cmath>

#include "solver/batch/lanes/steps-inl.hpp"
#include "solver/batch/lanes/zone-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Estimates where an impact in a cohesive zone turns, from the law F = u^6 - f3 u^3 - f0, d(delta)/du =
/// 4 u^3 - d0 in units of Maugis: between DMT and JKR, with the equilibrium of the curve.
class ZoneTurn {
  public:
    ZoneTurn() = default;
    HWY_INLINE explicit ZoneTurn(const Equation<ZoneForm>& e) {
        static const double root = std::sqrt(6.0);  // F of JKR is u^6 - root u^3, of DMT u^6 - 2
        const Lanes rest = e.of_curve([](const batch::ZoneCurve& c) { return c.rest().place.position; });
        const Lanes cube = rest * rest * rest;
        const Lanes share = (cube * cube - Lanes(2.0)) / multiply_add(cube, root, -2.0);
        const Lanes jkr = min(max(share, 0.0), 1.0);
        f3_ = jkr * Lanes(root);
        f0_ = multiply_add(jkr, -2.0, 2.0);
        d0_ = f3_ * Lanes(2.0 / 3.0);
        position_ = max(rest * Lanes(1.3), Lanes(1.03) / sqrt(e.radius_unit));
    }

    /// Improves the estimate by a state before the turn, by so many steps of Newton's method.
    HWY_INLINE void improve(const Equation<ZoneForm>& e, Lanes q, Lanes v, Mask before, int steps) {
        constexpr double mean_speed = 0.7;  // of v
        const Lanes pace = Lanes(mean_speed) * v * e.damping * e.impulse_unit() / e.energy_unit;
        const Lanes share(4.0 / (e.law->power + 4));
        const auto work = [&](Lanes u) HWY_ATTR {
            const Lanes u2 = u * u;
            return multiply_add(e.power_of(u) * u2 * u2, pace * share, potential(u));
        };
        const Lanes wanted = multiply_add(v * v, Lanes(0.5) / e.energy_unit, work(q));
        Lanes u = position_;
        for (int i = 0; i < steps; ++i) {
            const Lanes u3 = u * u * u;
            const Lanes slope = slope_at(u3) * multiply_add(e.power_of(u), pace, force_at(u3));
            u = max(u - (work(u) - wanted) / slope, q * Lanes(1.01));
        }
        position_ = select(before, u, position_);
        const Lanes u2 = position_ * position_;
        const Lanes u3 = u2 * position_;
        const Lanes slope = slope_at(u3);
        const Lanes drag = e.damping_at(position_) * e.overlap_unit * slope;
        const Lanes force_slope = u2 * multiply_add(u3, 6.0, f3_ * Lanes(-3.0));
        const Lanes stiffness_slope = multiply_add(force_slope, slope, Lanes(12.0) * u2 * force_at(u3));
        time_ = Lanes(1.0) / sqrt(multiply_add(drag, drag, max(e.energy_unit * stiffness_slope, 0.0)));
        damping_ = drag * time_;
    }
    [[nodiscard]] HWY_INLINE Lanes position() const { return position_; }
    [[nodiscard]] HWY_INLINE Lanes time() const { return time_; }        ///< pseudo-time of a radian
    [[nodiscard]] HWY_INLINE Lanes damping() const { return damping_; }  ///< drag times that

  private:
    [[nodiscard]] HWY_INLINE Lanes force_at(Lanes u3) const { return multiply_add(u3 - f3_, u3, -f0_); }
    [[nodiscard]] HWY_INLINE Lanes slope_at(Lanes u3) const { return multiply_add(u3, 4.0, -d0_); }
    [[nodiscard]] HWY_INLINE Lanes potential(Lanes u) const {
        const Lanes u3 = u * u * u;
        const Lanes seventh = multiply_add(f3_, 4.0, d0_) * Lanes(-1.0 / 7.0);
        const Lanes fourth = multiply_add(f3_ * d0_, 0.25, -f0_);
        return u * multiply_add(multiply_add(multiply_add(u3, 0.4, seventh), u3, fourth), u3, f0_ * d0_);
    }

    Lanes f3_;
    Lanes f0_;
    Lanes d0_;
    Lanes position_;
    Lanes time_;
    Lanes damping_;
};

/// Chooses the steps of an impact in a cohesive zone: those expected of its place on the way to the turn or
/// back, times a factor that is learnt from the errors.
class ZonePilot {
  public:
    ZonePilot() = default;
    /// Of a motion next to its turn.
    HWY_INLINE explicit ZonePilot(Lanes first) : log_expected_(rough_log2(first)) {}

    /// Expects the step from a state. The polynomials are a fit to the steps of random impacts.
    HWY_INLINE void observe(const Equation<ZoneForm>& equation, Lanes q, Lanes v, Mask approaching) {
        constexpr int first_steps = 4;
        const Mask before = both(approaching, v > Lanes(0.0));
        if (!known_) turn_ = ZoneTurn(equation);
        if (any(before)) turn_.improve(equation, q, v, before, known_ ? 1 : first_steps);
        known_ = true;
        const Lanes way = max(Lanes(1.0) - q / turn_.position(), 0.0);
        const Lanes free = way / multiply_add(turn_.damping(), 3.0, 1.0);
        const Lanes inward = multiply_add(free, multiply_add(way, 1.8, 1.3), 0.87);
        const Lanes outward = multiply_add(way, multiply_add(way / max(abs(v), 0.3), 4.0, 2.2), 0.95);
        log_expected_ = rough_log2(turn_.time() * select(approaching, inward, outward));
    }
    [[nodiscard]] HWY_INLINE Lanes step() const { return rough_exp2(log_expected_ + log_factor_); }
    /// Estimate of the greatest q.
    [[nodiscard]] HWY_INLINE Lanes turn() const { return turn_.position(); }
    /// As those of Pilot.
    [[nodiscard]] HWY_INLINE Lanes reach() const { return reach_; }
    template <int order>
    HWY_INLINE Mask judge(Lanes taken, Lanes error, Mask /*inward*/, Mask active) {
        constexpr double floor = 1e-6 * Pilot::tolerance;
        const Mask good = error <= Lanes(Pilot::acceptable * Pilot::tolerance);
        const Lanes log_taken = rough_log2(taken);
        const Lanes gain =
            (rough_log2(Lanes(Pilot::tolerance)) - rough_log2(max(error, floor))) * Lanes(1.0 / order);
        const Lanes ideal = log_taken + max(gain, -1.0) - log_expected_;
        const Lanes next = min(ideal, log_factor_ + Lanes(0.3)) - Lanes(0.1);
        // An accurate step that was shortened for an event or a piece does not determine the next one.
        const Mask telling =
            without(active, both(good, log_taken < log_expected_ + log_factor_ - Lanes(0.2)));
        log_factor_ = select(telling, next, log_factor_);
        reach_ = select(good, Lanes(Pilot::longest_reach), 1.0);
        return good;
    }

  private:
    ZoneTurn turn_;
    bool known_ = false;
    Lanes log_expected_;
    Lanes log_factor_{0.0};
    Lanes reach_{Pilot::longest_reach};
};

/// Of a form.
template <class F>
struct PilotOf {
    using Type = Pilot;
};
template <>
struct PilotOf<ZoneForm> {
    using Type = ZonePilot;
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
