// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#endif

#include "solver/batch/lanes/findings-inl.hpp"
#include "solver/batch/lanes/pilot-inl.hpp"
#include "solver/batch/lanes/turn-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Integrates the impacts of one register of lanes independently. A lane that has ended no longer changes.
template <class F>
class LaneOrbit {
  public:
    static constexpr int sequences = 8;
    static constexpr int sequences_to_turn = 6;  ///< of the step to the turn, half as long or less
    static constexpr int late = 5;  ///< creeping is tested only from this step on; it is rare and slow

    LaneOrbit() = default;
    /// @param goal what is to be found; for the turn alone the motion ends soon after it
    HWY_INLINE LaneOrbit(const Equation<F>& equation, Detachment detachment, Goal goal)
        : equation_(equation),
          places_(places_of(equation, detachment)),
          pilot_(inward_step(equation, places_)),
          error_scale_(Lanes(F::Damping::error_weight) / places_.speed_squared),
          goal_(goal),
          approaching_(every()),
          active_(every()) {
        state_.position = places_.touch;
        state_.momentum = Lanes(1.0) + equation.damping_impulse(places_.touch);
        state_.time = 0.0;
        found_.turn = found_.end = state_;
    }

    /// Goes back to a state beside the turn, to end at the turning point; the step from there is chosen. What
    /// was found before is forgotten, but which lanes never turn.
    HWY_INLINE void return_to_turn() {
        const StepToTurn next = around_.step_to_turn();
        state_ = next.state;
        step_ = next.step;
        speed_ = abs(next.velocity);
        stiffness_ = 0.0;
        pilot_ = Pilot(next.usual);
        to_turn_ = true;
        found_.forget();
        approaching_ = active_ = without(every(), found_.never_turns);
    }

    [[nodiscard]] HWY_INLINE const Equation<F>& equation() const { return equation_; }
    [[nodiscard]] HWY_INLINE const LaneState& state() const { return state_; }
    [[nodiscard]] HWY_INLINE Lanes step() const { return step_; }
    [[nodiscard]] HWY_INLINE Mask active() const { return active_; }

    /// Detects events at the present state and chooses the next step.
    HWY_INLINE void observe(int pass) {
        const Lanes q = state_.position;
        const Lanes v = equation_.velocity(state_);
        const Rates r = rates_of(equation_, q, v);
        const Lanes usual = pilot_.step();
        if (!to_turn_) {
            if (goal_ != Goal::end && any(approaching_))
                around_.observe(approaching_, state_, v, r.acceleration, usual, step_);
            approaching_ = without(approaching_, v <= Lanes(0.0));
            if (goal_ == Goal::turn) active_ = both(active_, approaching_);
        }
        const NextEvent next(places_, approaching_);
        Lanes event = next.time(q, v, r);
        if (!to_turn_) event = select(approaching_, NextEvent::out_of_sight, event);
        const Lanes reach = next.reach(q, v, usual);
        const Mask near = both(active_, abs(event) <= (to_turn_ ? reach * Lanes(turn_reach) : reach));
        const Mask turning = both(near, approaching_);
        const Mask ending = both(without(near, approaching_), v < Lanes(0.0));
        found_.record(turning, ending, state_);
        active_ = without(active_, ending);
        approaching_ = without(approaching_, turning);
        if (to_turn_) active_ = without(active_, turning);
        const LaneVerdict verdict = LaneCapture<F>(equation_, places_)
                                        .verdict(q, v, active_, approaching_, !to_turn_ && pass >= late);
        found_.record(verdict);
        active_ = without(active_, verdict.captured);
        const Mask within = without(event < usual * pilot_.reach(), turning);
        step_ = select(within, max(event, -usual), usual);
        speed_ = abs(v);
        stiffness_ = abs(r.stiffness);
    }

    /// Accepts the step if its error is small enough.
    HWY_INLINE void take(const LaneStep& step) {
        LaneState next;
        next.position = state_.position + step.change.position;
        next.momentum = state_.momentum + step.change.momentum;
        next.time = state_.time + step.change.time;
        const Lanes v = equation_.velocity(next);
        const Lanes error = multiply_add(max(speed_, abs(v)), abs(step.momentum_error),
                                         max(stiffness_, abs(step.end_stiffness)) * abs(step.position_error));
        // A step after which the overlap grows again may have passed the end of contact.
        const Mask returned = without(v > Lanes(0.0), approaching_);
        const Lanes judged = select(returned, returned_error, error * error_scale_);
        const Mask good =
            pilot_.template judge<2 * sequences - 1>(abs(step_), judged, v > Lanes(0.0), active_);
        const Mask taken = both(good, active_);
        state_ = select(taken, next, state_);
    }

    /// Greatest overlap and its time; for a lane that never turns the supremum, and NaN for the time.
    [[nodiscard]] HWY_INLINE LaneTurn turning_point() const {
        return HWY_NAMESPACE::turning_point(equation_, places_, found_.turn, found_.turned);
    }
    /// Speed and time at the end of contact.
    [[nodiscard]] HWY_INLINE LaneArrival end_point() const {
        return HWY_NAMESPACE::end_point(equation_, places_, found_.end);
    }
    [[nodiscard]] HWY_INLINE Mask surely_ended(const LaneArrival& end) const {
        return found_.surely_ended(end, places_);
    }
    [[nodiscard]] HWY_INLINE Mask surely_turned(Lanes time) const {
        return found_.surely_turned(time, equation_, places_);
    }
    [[nodiscard]] HWY_INLINE Mask surely_captured() const { return found_.surely_captured(); }

  private:
    static constexpr double returned_error = 1.0;  ///< so large that the pilot shortens the step most

    Equation<F> equation_;
    Places places_;
    Pilot pilot_;
    Lanes error_scale_;  ///< error_weight (3 for Tsuji, whose estimates can be too low) over v^2 in the well
    LaneState state_;
    LaneFindings found_;
    AroundTurn around_;
    Lanes step_;
    Lanes speed_;
    Lanes stiffness_;
    Goal goal_ = Goal::end;
    bool to_turn_ = false;  ///< whether it returned and stops at the turning point
    Mask approaching_;
    Mask active_;
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
