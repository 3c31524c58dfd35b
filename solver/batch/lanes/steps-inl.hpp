// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_STEPS_INL_HPP
#endif

#include <cmath>

#include "solver/batch/lanes/equation-inl.hpp"
#include "solver/batch/lanes/events-inl.hpp"
#include "solver/batch/lanes/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Step for the approach: a part of the period of the motion about the estimated greatest q, where the period
/// is shortest. The estimate balances the incident energy with the potential and the work of damping at a
/// mean speed.
template <class F>
[[nodiscard]] HWY_INLINE Lanes inward_step(const Equation<F>& equation, const Places& places) {
    constexpr double part = 1.3;         // of a radian
    constexpr double mean_speed = 0.72;  // of v_in
    constexpr int degree = F::potential.degree();
    static const double free_turn = std::pow(1.0 / F::potential.at(degree, 0), 1.0 / degree);
    static const double bound_turn =
        std::pow(1.36 * 1.15, 5.0 / degree);  // of DMT; that of the other laws is less
    const Lanes a = equation.adhesion;
    const Lanes brake = equation.damping * Lanes(mean_speed);
    const auto work = [&](Lanes q) HWY_ATTR {
        return multiply_add(value_of<F::impulse>(a, q), brake, equation.potential(q));
    };
    const Lanes wanted = work(places.touch) + Lanes(0.5);
    Lanes q = max(places.equilibrium * Lanes(bound_turn), free_turn);
    for (int i = 0; i < 4; ++i) {  // convex and increasing there: Newton comes down to the root
        const Lanes slope = multiply_add(value_of<F::drag>(a, q), brake, value_of<F::stiffness>(a, q));
        q = q - (work(q) - wanted) / slope;
    }
    const Lanes drag = equation.damping * value_of<F::drag>(a, q);
    return Lanes(part) / sqrt(multiply_add(drag, drag, value_of<F::stiffness_slope>(a, q)));
}

/// Chooses steps. During the approach they stay constant unless the error is far from the tolerance. During
/// the rebound the ideal step grows by a factor that changes little from step to step, so it is extrapolated
/// (predictive controller, Gustafsson 1994). Hardly any step has to be repeated.
class Pilot {
  public:
    static constexpr double tolerance = 0.8e-12;  ///< of the estimate, which is far above the error
    static constexpr double acceptable = 2.5;     ///< tolerances up to which a step is kept

    Pilot() = default;
    HWY_INLINE explicit Pilot(Lanes first) : log_step_(rough_log2(first)) {}

    [[nodiscard]] HWY_INLINE Lanes step() const { return rough_exp2(log_step_); }
    /// Longest step to an event, as a multiple of step(); 1 after a step that failed.
    [[nodiscard]] HWY_INLINE Lanes reach() const { return reach_; }

    /// Chooses the next step from the size @p taken of the last one and its error estimate @p error.
    /// @param inward lanes whose overlap still grows
    /// @return lanes whose step is accurate enough to be kept
    template <int order>
    HWY_INLINE Mask judge(Lanes taken, Lanes error, Mask inward, Mask active) {
        constexpr double floor = 1e-6 * tolerance;
        const Mask good = error <= Lanes(acceptable * tolerance);
        const Lanes log_taken = rough_log2(taken);
        const Lanes gain =
            (rough_log2(Lanes(tolerance)) - rough_log2(max(error, floor))) * Lanes(1.0 / order);
        const Lanes ideal = log_taken + gain;
        const Lanes trend = min(max(ideal - last_ideal_, 0.0), 0.4);
        const Mask left = leaving_ > Lanes(0.0);
        const Lanes outward =
            min(ideal + select(left, trend, first_trend), log_taken + select(left, Lanes(0.45), Lanes(0.25)));
        const Lanes steady = log_taken + min(max(gain - Lanes(0.35), 0.0), 0.3) * touched_;
        const Lanes next = select(good, select(inward, steady, outward), ideal - Lanes(0.1));
        // An accurate step that was shortened for an event does not determine the next one.
        const Mask telling = without(active, both(good, log_taken < log_step_ - Lanes(0.2)));
        log_step_ = select(telling, next, log_step_);
        last_ideal_ = select(telling, ideal, last_ideal_);
        leaving_ = select(both(telling, without(good, inward)), 1.0, leaving_);
        touched_ = 1.0;
        reach_ = select(good, Lanes(longest_reach), 1.0);
        return good;
    }

  private:
    static constexpr double first_trend = 0.1;
    static constexpr double longest_reach = 1.1;
    Lanes log_step_;
    Lanes last_ideal_{0.0};
    Lanes leaving_{0.0};  ///< 1 if the last ideal step was one of the rebound
    Lanes touched_{0.0};  ///< 0 during the first step, in which too little happens to judge the step
    Lanes reach_{longest_reach};
};

/// What is to be found of an impact. Both are found by the same steps alone and together, so that asking for
/// the one does not change the other.
enum class Goal { end, turn, end_and_turn };

/// How near to the turn the series is used, as a part of how near to other events: turn_order is lower.
inline constexpr double turn_reach = 1.0 / 3.0;

/// Where on the way from 0 to 1 the cubic with the values @p f0 > 0 and @p f1 <= 0 and the slopes @p d0 and
/// @p d1 at the ends vanishes.
[[nodiscard]] HWY_INLINE Lanes falling_root(Lanes f0, Lanes d0, Lanes f1, Lanes d1) {
    const Lanes change = f1 - f0;
    const Lanes c2 = multiply_add(change, 3.0, -(d0 + d0 + d1));
    const Lanes c3 = multiply_add(change, -2.0, d0 + d1);
    Lanes s = -f0 / change;
    for (int i = 0; i < 3; ++i) {
        const Lanes value = multiply_add(multiply_add(multiply_add(c3, s, c2), s, d0), s, f0);
        const Lanes slope = multiply_add(multiply_add(c3 * Lanes(3.0), s, c2 + c2), s, d0);
        s = min(max(s - value / slope, 0.0), 1.0);
    }
    return s;
}

/// Where and how a step to the turning point begins.
struct StepToTurn {
    LaneState state;
    Lanes velocity;
    Lanes step;   ///< below zero from a state after the turn; the usual one for a lane that has not turned
    Lanes usual;  ///< step that the pilot chose before the turn
};

/// The last state of each lane before its turn and the first one after it. From the nearer one a single step
/// reaches the turning point.
class AroundTurn {
  public:
    AroundTurn() = default;

    /// Records a state of the motion.
    /// @param approaching lanes that had not turned before
    /// @param usual step that the pilot chooses now; @param taken step that led here
    HWY_INLINE void observe(Mask approaching, const LaneState& state, Lanes v, Lanes acceleration,
                            Lanes usual, Lanes taken) {
        const Mask passed = both(approaching, v <= Lanes(0.0));
        const Mask inward = without(approaching, passed);
        before_ = select(inward, state, before_);
        velocity_ = select(inward, v, velocity_);
        acceleration_ = select(inward, acceleration, acceleration_);
        usual_ = select(inward, usual, usual_);
        if (!any(passed)) return;
        after_ = select(passed, state, after_);
        step_ = select(passed, taken, step_);
        later_velocity_ = select(passed, v, later_velocity_);
        later_acceleration_ = select(passed, acceleration, later_acceleration_);
        passed_ = either(passed_, passed);
    }

    [[nodiscard]] HWY_INLINE StepToTurn step_to_turn() const {
        const Lanes part =
            falling_root(velocity_, acceleration_ * step_, later_velocity_, later_acceleration_ * step_);
        const Mask late = both(passed_, part > Lanes(0.5));
        const Lanes step = select(late, (part - Lanes(1.0)) * step_, part * step_);
        return {select(late, after_, before_), select(late, later_velocity_, velocity_),
                select(passed_, step, usual_), usual_};
    }

  private:
    LaneState before_;
    LaneState after_;
    Lanes velocity_;
    Lanes acceleration_;
    Lanes usual_;
    Lanes step_{1.0};
    Lanes later_velocity_{0.0};
    Lanes later_acceleration_{0.0};
    Mask passed_ = none();
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
