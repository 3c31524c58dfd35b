// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_TURN_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_TURN_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_TURN_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_TURN_INL_HPP
#endif

#include "solver/batch/lanes/equation-inl.hpp"
#include "solver/batch/lanes/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

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
