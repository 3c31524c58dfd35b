// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ORBIT_INL_HPP
#endif

#include <cstdint>
#include <type_traits>

#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/lanes/steps-inl.hpp"
#include "solver/batch/lanes/zone_events-inl.hpp"
#include "solver/batch/lanes/zone_steps-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

inline constexpr std::size_t block_size = group_count * lane_count;
inline constexpr int most_passes = 64;  ///< steps; an impact that needs more is left to the scalar solver

/// Scaled impacts of one block with their results.
struct Block {
    HWY_ALIGN double adhesion[block_size];
    HWY_ALIGN double damping[block_size];
    HWY_ALIGN double yield_number[block_size];  ///< of a form that yields; otherwise unused
    const batch::ZoneCurve* curve[block_size];  ///< of ZoneForm; otherwise unused, as the next
    const ZoneDamping* law;
    HWY_ALIGN double speed[block_size];         ///< at the end of contact
    HWY_ALIGN double time[block_size];          ///< of contact
    HWY_ALIGN double turn_time[block_size];     ///< NaN where it never turns
    HWY_ALIGN double turn_overlap[block_size];  ///< or its supremum
    HWY_ALIGN double turn_place[block_size];    ///< q
    std::uint64_t rebound;                      ///< one bit a lane; set only if certain
    std::uint64_t capture;                      ///< one bit a lane; set only if certain
    std::uint64_t turn;                         ///< one bit a lane; turning point known

    [[nodiscard]] bool rebounds(std::size_t lane) const { return ((rebound >> lane) & 1U) != 0; }
    [[nodiscard]] bool captures(std::size_t lane) const { return ((capture >> lane) & 1U) != 0; }
    [[nodiscard]] bool turns(std::size_t lane) const { return ((turn >> lane) & 1U) != 0; }
    [[nodiscard]] batch::LaneEnd end(std::size_t lane) const {
        if (rebounds(lane)) return batch::LaneEnd::rebound;
        return captures(lane) ? batch::LaneEnd::capture : batch::LaneEnd::undecided;
    }
};

[[nodiscard]] HWY_INLINE std::uint64_t bits_of(Mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Tag(), mask, bytes);
    return bytes[0];
}

/// Integrates the impacts of one register of lanes independently. A lane that has ended no longer changes.
template <class F>
class LaneOrbit {
  public:
    /// In a cohesive zone the pieces of its curve limit the steps.
    static constexpr int sequences = std::is_same_v<F, ZoneForm> ? 6 : 8;
    static constexpr int sequences_to_turn =
        sequences - 2;  ///< of the step to the turn, half as long or less
    /// Creeping is tested only from this step on; the test is slow.
    static constexpr int late = std::is_same_v<F, ZoneForm> ? 2 : 5;

    LaneOrbit() = default;
    /// An impact from first touch on. @param goal what is to be found; for the turn alone the motion ends
    /// soon after it
    HWY_INLINE LaneOrbit(const Equation<F>& equation, const Places& places, Goal goal)
        : LaneOrbit(equation, places, inward_step(equation, places), every(), every()) {
        goal_ = goal;
    }
    /// The part of an impact from its turn on, or from a later place up to it, of the lanes that are @p
    /// active.
    /// @param places touch, touch_speed and touch_time are those of the beginning
    HWY_INLINE LaneOrbit(const Equation<F>& equation, const Places& places, Lanes step, Mask approaching,
                         Mask active)
        : equation_(equation),
          places_(places),
          pilot_(step),
          error_scale_(equation_.error_weight() / places_.speed_squared),
          approaching_(approaching),
          active_(active) {
        state_.position = places_.touch;
        equation_.prepare(places_.touch, every(), every());
        state_.momentum = places_.touch_speed + equation_.damping_impulse(places_.touch);
        state_.time = places_.touch_time;
        found_.turn = found_.end = state_;
    }
    /// Ends the motion at the turning point.
    HWY_INLINE void stop_at_turn() { to_turn_ = true; }

    /// Goes back to a state beside the turn, to end at the turning point; the step from there is chosen. What
    /// was found before is forgotten, but which lanes never turn.
    HWY_INLINE void return_to_turn() {
        const StepToTurn next = around_.step_to_turn();
        state_ = next.state;
        step_ = next.step;
        speed_ = abs(next.velocity);
        stiffness_ = 0.0;
        pilot_ = PilotType(next.usual);
        pass_ = late;
        to_turn_ = returned_ = true;
        found_.forget();
        approaching_ = active_ = without(every(), found_.never_turns);
        equation_.prepare(state_.position, active_, next.velocity > Lanes(0.0));
    }

    [[nodiscard]] HWY_INLINE const Equation<F>& equation() const { return equation_; }
    [[nodiscard]] HWY_INLINE const LaneState& state() const { return state_; }
    [[nodiscard]] HWY_INLINE Lanes step() const { return step_; }
    [[nodiscard]] HWY_INLINE Mask active() const { return active_; }
    [[nodiscard]] HWY_INLINE const Places& places() const { return places_; }
    [[nodiscard]] HWY_INLINE const LaneFindings& found() const { return found_; }

    /// Detects events at the present state and chooses the next step. After most_passes no lane is active.
    HWY_INLINE void observe() {
        const int pass = pass_++;
        if (pass >= most_passes) active_ = none();
        if (!any(active_)) return;
        const Lanes q = state_.position;
        const Lanes v = equation_.velocity(state_);
        const Rates r = rates_of(equation_, q, v);
        if constexpr (std::is_same_v<F, ZoneForm>)
            if (!to_turn_) pilot_.observe(equation_, q, v, approaching_);
        const Lanes usual = pilot_.step();
        if (!to_turn_) {
            if (goal_ != Goal::end && any(approaching_))
                around_.observe(approaching_, state_, v, r.acceleration, usual, step_);
            approaching_ = without(approaching_, v <= Lanes(0.0));
            if (goal_ == Goal::turn) active_ = both(active_, approaching_);
        }
        const NextEvent next(places_, approaching_);
        Lanes event = next.time(q, v, r);
        if (!to_turn_) {
            Lanes leaves = NextEvent::out_of_sight;
            if constexpr (F::yields) leaves = next.time_to_yield(q, v, r);
            event = select(approaching_, leaves, event);
        }
        if constexpr (std::is_same_v<F, ZoneForm>) {
            const Lanes ahead = min(event, usual * Lanes(Pilot::longest_reach));
            const Mask leaving = equation_.longest_step(q, v, r.acceleration, ahead) < ahead;
            equation_.prepare(q, both(active_, leaving), v > Lanes(0.0), pilot_.turn());
        }
        const Lanes reach = next.reach(q, v, usual);
        const Mask near = both(active_, abs(event) <= (to_turn_ ? reach * Lanes(turn_reach) : reach));
        const Mask turning = both(near, approaching_);
        const Mask ending = both(without(near, approaching_), v < Lanes(0.0));
        found_.record(turning, ending, state_);
        active_ = without(active_, ending);
        approaching_ = without(approaching_, turning);
        if (to_turn_ || F::yields) active_ = without(active_, turning);
        const LaneVerdict verdict = LaneCapture<F>(equation_, places_)
                                        .verdict(q, v, active_, approaching_, !returned_ && pass >= late);
        found_.record(verdict);
        active_ = without(active_, verdict.captured);
        const Mask within = without(event < usual * pilot_.reach(), turning);
        step_ = equation_.longest_step(q, v, r.acceleration, select(within, max(event, -usual), usual));
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
        Mask returned =
            either(without(v > Lanes(0.0), approaching_), without(every(), equation_.knows(next.position)));
        if constexpr (F::yields)
            if (!to_turn_) returned = either(returned, both(approaching_, may_have_yielded(v)));
        const Lanes judged = select(returned, returned_error, error * error_scale_);
        const Mask good =
            pilot_.template judge<2 * sequences - 1>(abs(step_), judged, v > Lanes(0.0), active_);
        const Mask taken = both(good, active_);
        state_ = select(taken, next, state_);
    }

    /// Writes the ends of the impacts into the lanes of a block from @p first on.
    HWY_INLINE void store_end(Block& block, std::size_t first) const {
        const LaneArrival end = arrival();
        end.time.store(block.time + first);
        end.speed.store(block.speed + first);
        block.rebound |= bits_of(rebounds(end)) << first;
        block.capture |= bits_of(captures()) << first;
    }
    HWY_INLINE void store_turn(Block& block, std::size_t first) const {
        const LaneTurn turn = this->turn();
        block.turn |= bits_of(turns(turn)) << first;
        turn.time.store(block.turn_time + first);
        turn.overlap.store(block.turn_overlap + first);
        turn.position.store(block.turn_place + first);
    }

    /// Outside of contact.
    [[nodiscard]] HWY_INLINE LaneArrival arrival() const {
        return separated(equation_, places_,
                         arrival_at(equation_, places_.end, places_.by_force, found_.end));
    }
    [[nodiscard]] HWY_INLINE Mask rebounds(const LaneArrival& arrival) const {
        return found_.surely_ended(arrival, places_);
    }
    [[nodiscard]] HWY_INLINE Mask captures() const { return found_.captured; }
    [[nodiscard]] HWY_INLINE LaneTurn turn() const {
        return turning_point(equation_, places_, found_.turn, found_.turned);
    }
    [[nodiscard]] HWY_INLINE Mask turns(const LaneTurn& turn) const {
        return found_.surely_turned(turn.time, equation_, places_);
    }

  private:
    using PilotType = typename PilotOf<F>::Type;

    /// Lanes that turn in this step, perhaps beyond yield. @param v at its end
    [[nodiscard]] HWY_INLINE Mask may_have_yielded(Lanes v) const {
        constexpr double margin = 1.5;  // over the rise at a constant acceleration
        const Lanes rise = speed_ * speed_ * step_ / (speed_ - v) * Lanes(0.5);
        return both(v <= Lanes(0.0), multiply_add(rise, margin, state_.position) >= places_.yield);
    }

    static constexpr double returned_error = 1.0;  ///< so large that the pilot shortens the step most

    Equation<F> equation_;
    Places places_;
    PilotType pilot_;
    Lanes error_scale_;  ///< error_weight (3 for Tsuji, whose estimates can be too low) over v^2 in the well
    LaneState state_;
    LaneFindings found_;
    AroundTurn around_;
    Lanes step_;
    Lanes speed_;
    Lanes stiffness_;
    Goal goal_ = Goal::end;
    int pass_ = 0;           ///< steps that each lane has tried at least
    bool to_turn_ = false;   ///< whether it stops at the turning point
    bool returned_ = false;  ///< to beside the turn
    Mask approaching_;
    Mask active_;
};

/// One step of each orbit.
template <class F, int sequences = LaneOrbit<F>::sequences>
HWY_INLINE void advance(Groups<LaneOrbit<F>>& orbits) {
    Groups<LaneStep> steps;
    ExtrapolatedLeapfrog<F, sequences, LaneOrbit<F>>::step(orbits, steps);
    for (std::size_t group = 0; group < group_count; ++group) orbits[group].take(steps[group]);
}

/// Steps orbits until none is active.
/// @param refill called with a group without active lanes; returns whether it has put other impacts there
template <class F, class Refill>
HWY_INLINE void integrate(Groups<LaneOrbit<F>>& orbits, const Refill& refill) {
    while (true) {
        Mask active = none();
        for (std::size_t group = 0; group < group_count;) {
            orbits[group].observe();
            if (!any(orbits[group].active()) && refill(group)) continue;
            active = either(active, orbits[group].active());
            ++group;
        }
        if (!any(active)) break;
        advance<F>(orbits);
    }
}
template <class F>
HWY_INLINE void integrate(Groups<LaneOrbit<F>>& orbits) {
    integrate<F>(orbits, [](std::size_t /*group*/) { return false; });
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
