// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_ARRIVALS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_ARRIVALS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_ARRIVALS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_ARRIVALS_INL_HPP
#endif

#include "solver/batch/lanes/capture-inl.hpp"
#include "solver/batch/lanes/landing-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// A turning point, scaled.
struct LaneTurn {
    Lanes time;
    Lanes overlap;
};

/// An arrival at the end of contact, scaled.
struct LaneArrival {
    Lanes speed;
    Lanes time;
    Mask found;  ///< whether Newton's method converged; not if the end is next to a turn
};

inline constexpr int landing_order = 10;  ///< of the Taylor series about a state next to an event
inline constexpr int turn_order = 7;      ///< of that at a turn, which the state is nearer to
inline constexpr int newton_steps = 4;

/// Greatest overlap and its time, from a state next to the turn. A lane that never @p turned gets the
/// supremum of the overlap, and NaN for the time.
template <class F>
[[nodiscard]] HWY_INLINE LaneTurn turning_point(const Equation<F>& equation, const Places& places,
                                                const LaneState& near, Mask turned) {
    const LaneSeries<F, turn_order> x(equation, near);
    Lanes h = 0.0;
    for (int i = 1; i < newton_steps; ++i) h = h - x.velocity_at(h) / x.acceleration_at(h);
    LaneTurn turn;
    turn.time = select(turned, x.time_at(h), Lanes(hn::NaN(Tag())));
    turn.overlap = equation.overlap(select(turned, x.position_at(h), places.equilibrium));
    return turn;
}

/// Speed and time at the end of contact, from a state next to it.
template <class F>
[[nodiscard]] HWY_INLINE LaneArrival end_point(const Equation<F>& equation, const Places& places,
                                               const LaneState& near) {
    const LaneSeries<F, landing_order> x(equation, near);
    Lanes h = 0.0;
    Lanes move = 0.0;
    for (int i = 0; i < newton_steps; ++i) {
        move = (x.position_at(h) - places.end) / x.velocity_at(h);
        if (any(places.by_force)) move = select(places.by_force, x.acceleration_at(h) / x.jerk_at(h), move);
        h = h - move;
    }
    return {-x.velocity_at(h), x.time_at(h), abs(move) < Lanes(1e-8)};
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
