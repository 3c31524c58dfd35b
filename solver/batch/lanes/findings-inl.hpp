// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_FINDINGS_INL_HPP
#endif

#include "solver/batch/lanes/arrivals-inl.hpp"
#include "solver/batch/lanes/events-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// What was found of the impacts of the lanes.
struct LaneFindings {
    LaneFindings() = default;

    LaneState turn;  ///< next to the turning point
    LaneState end;   ///< next to the end of contact
    Mask captured = none();
    Mask turned = none();
    Mask ended = none();
    Mask doubtful = none();     ///< captured or not, for lack of digits in the energy
    Mask never_turns = none();  ///< creeps up to equilibrium

    /// Forgets all but the lanes that never turn.
    HWY_INLINE void forget() { captured = turned = ended = doubtful = none(); }

    HWY_INLINE void record(Mask turning, Mask ending, const LaneState& state) {
        turn = select(turning, state, turn);
        end = select(ending, state, end);
        turned = either(turned, turning);
        ended = either(ended, ending);
    }
    HWY_INLINE void record(const LaneVerdict& verdict) {
        doubtful = either(doubtful, verdict.doubtful);
        captured = either(captured, verdict.captured);
        never_turns = either(never_turns, verdict.never_turn);
    }

    /// Lanes that have certainly ended, with a reliable speed.
    [[nodiscard]] HWY_INLINE Mask surely_ended(const LaneArrival& arrival, const Places& places) const {
        const Mask fast = arrival.speed * arrival.speed > places.speed_squared * Lanes(energy_doubt);
        return both(both(ended, arrival.found), both(fast, places.speed_squared < Lanes(deepest_well)));
    }
    /// Lanes whose turning point at @p time, or its absence, is certain. In doubt are those that turn while
    /// hardly anything pulls them back: where that changes the speed by 1e-4 of what it is in the well,
    /// errors of 1e-12 move the time by 1e-8 of itself.
    template <class F>
    [[nodiscard]] HWY_INLINE Mask surely_turned(Lanes time, const Equation<F>& equation,
                                                const Places& places) const {
        const Lanes slope = value_of<F::slope>(equation.adhesion, turn.position);
        const Lanes pull = rates_of(equation, turn.position, Lanes(0.0)).acceleration / slope * time;
        const Mask doubt = pull * pull < places.speed_squared * Lanes(1e-8);
        return either(without(turned, doubt), never_turns);
    }
    /// Captured lanes, except those in doubt.
    [[nodiscard]] HWY_INLINE Mask surely_captured() const { return without(captured, doubtful); }
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
