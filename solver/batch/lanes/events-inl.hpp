// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_EVENTS_INL_HPP
#endif

#include "solver/batch/lanes/capture-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// How a state changes with pseudo-time.
struct Rates {
    Lanes stiffness;     ///< h
    Lanes acceleration;  ///< dv/dtheta
    Lanes jerk;          ///< d2v/dtheta2
};

template <class F>
[[nodiscard]] HWY_INLINE Rates rates_of(const Equation<F>& equation, Lanes q, Lanes v) {
    const Lanes beta = equation.damping;
    const Lanes drag = beta * value_of<F::drag>(equation.adhesion, q);
    const Lanes drag_slope = beta * value_of<F::drag_slope>(equation.adhesion, q);
    Rates r;
    r.stiffness = value_of<F::stiffness>(equation.adhesion, q);
    r.acceleration = -multiply_add(drag, v, r.stiffness);
    const Lanes spring = multiply_add(drag_slope, v, value_of<F::stiffness_slope>(equation.adhesion, q));
    r.jerk = -multiply_add(drag, r.acceleration, spring * v);
    return r;
}

/// Predicts the next event of each lane: the turning point for a lane that still approaches, else the end of
/// contact.
class NextEvent {
  public:
    static constexpr double out_of_sight = 1e300;  ///< pseudo-time to an event that is not predicted yet

    HWY_INLINE NextEvent(const Places& places, Mask approaching)
        : places_(places), approaching_(approaching) {}

    /// Pseudo-time to the event, from the expansion to third order: negative once the lane has passed it,
    /// out_of_sight if none is predicted.
    [[nodiscard]] HWY_INLINE Lanes time(Lanes q, Lanes v, const Rates& r) const {
        const Lanes third = r.jerk * Lanes(1.0 / 6.0);
        const Lanes half = r.acceleration * Lanes(0.5);
        const Lanes p0 = select(approaching_, v, select(places_.by_force, -r.acceleration, q - places_.end));
        const Lanes p1 = select(approaching_, r.acceleration, select(places_.by_force, -r.jerk, v));
        const Lanes p2 =
            select(approaching_, r.jerk * Lanes(0.5), select(places_.by_force, Lanes(0.0), half));
        const Lanes p3 = select(either(approaching_, places_.by_force), Lanes(0.0), third);
        const Lanes square = subtract_product(p1 * p1, Lanes(4.0) * p2, p0);
        const Lanes root = sqrt(max(square, 0.0));
        const Lanes h = Lanes(2.0) * p0 / (root - p1);
        const Lanes bend = p3 * h * h;
        const Lanes better = multiply_add(bend, h / subtract_product(root, bend, 3.0), h);
        const Mask mild = abs(bend) < Lanes(0.2) * root;
        const Mask real = square > Lanes(0.0);
        // Once the event is passed, the way back is known at least to first order.
        const Mask passed = both(p0 < Lanes(0.0), p1 < Lanes(0.0));
        const Lanes back = select(passed, -p0 / p1, out_of_sight);
        return select(both(p1 < Lanes(0.0), real), select(mild, better, h), back);
    }

    /// Pseudo-time before the event from which on its Taylor series is used. For an end by force it is also
    /// at most a small part of the way to zero overlap, where other roots lie.
    [[nodiscard]] HWY_INLINE Lanes reach(Lanes q, Lanes v, Lanes usual) const {
        const Lanes usual_reach = usual * Lanes(landing);
        if (!any(places_.by_force)) return usual_reach;
        const Lanes to_zero = abs(q / v) * Lanes(0.1 * landing);
        return select(without(places_.by_force, approaching_), min(usual_reach, to_zero), usual_reach);
    }

  private:
    static constexpr double landing = 0.06;  ///< part of a usual step

    const Places& places_;
    Mask approaching_;
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
