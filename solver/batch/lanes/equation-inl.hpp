// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP
#endif

#include "solver/batch/lanes/evaluate-inl.hpp"
#include "solver/batch/lanes/form.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Value of a symbol at @p x for the adhesion numbers of the lanes.
template <const Symbol& symbol>
[[nodiscard]] HWY_INLINE Lanes value_of(Lanes adhesion, Lanes x) {
    using Polynomial = Monic<symbol, true>;
    const Powers<Polynomial::Pattern::powers> powers(x);
    return Lanes(Polynomial::Pattern::leading) * Polynomial(adhesion)(powers);
}

/// State of an impact, scaled.
struct LaneState {
    Lanes position;  ///< q
    Lanes momentum;  ///< y = v + beta g(q)
    Lanes time;      ///< since first touch
};
HWY_INLINE LaneState select(Mask mask, const LaneState& yes, const LaneState& no) {
    return {select(mask, yes.position, no.position), select(mask, yes.momentum, no.momentum),
            select(mask, yes.time, no.time)};
}

/// The equation of motion of Form, for the adhesion and damping numbers of the lanes.
template <class F>
struct Equation {
    using Stiffness = Monic<F::stiffness, true>;
    using Impulse = Monic<F::impulse, true>;
    using Slope = Monic<F::slope, false>;
    static constexpr PowerSet powers =
        closed(Stiffness::Pattern::powers | Impulse::Pattern::powers | Slope::Pattern::powers);

    Lanes adhesion;
    Lanes damping;
    Stiffness stiffness;
    Impulse impulse;
    Slope slope;
    Lanes slope_constant;  ///< delta'(0), which slope leaves out

    Equation() = default;
    HWY_INLINE Equation(Lanes adhesion_number, Lanes damping_number)
        : adhesion(adhesion_number),
          damping(damping_number),
          stiffness(adhesion_number),
          impulse(adhesion_number),
          slope(adhesion_number),
          slope_constant(coefficient_of<F::slope, 0>(adhesion_number, 1.0)) {}

    /// beta g(q)
    [[nodiscard]] HWY_INLINE Lanes damping_impulse(Lanes q) const {
        return damping * value_of<F::impulse>(adhesion, q);
    }
    /// v = d(delta)/dt
    [[nodiscard]] HWY_INLINE Lanes velocity(const LaneState& state) const {
        return state.momentum - damping_impulse(state.position);
    }
    [[nodiscard]] HWY_INLINE Lanes potential(Lanes q) const { return value_of<F::potential>(adhesion, q); }
    [[nodiscard]] HWY_INLINE Lanes overlap(Lanes q) const { return value_of<F::overlap>(adhesion, q); }
    [[nodiscard]] HWY_INLINE Lanes force(Lanes q) const { return value_of<F::force>(adhesion, q); }
    /// eta(q)
    [[nodiscard]] HWY_INLINE Lanes damping_at(Lanes q) const {
        return damping * value_of<F::damping_of_state>(adhesion, q);
    }
};

/// Number of registers advanced together, so that the arithmetic of one hides the latency of another.
inline constexpr std::size_t group_count = 4;
template <class T>
using Groups = std::array<T, group_count>;

/// The change of a state in one step, with an estimate of its error.
struct LaneStep {
    LaneState change;
    Lanes position_error;
    Lanes momentum_error;
    Lanes end_stiffness;  ///< h(q) at the end, to second order
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
