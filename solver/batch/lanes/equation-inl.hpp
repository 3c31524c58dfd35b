// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_EQUATION_INL_HPP
#endif

#include <array>
#include <cstddef>

#include "solver/batch/lanes/form.hpp"
#include "solver/batch/lanes/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The powers x^k of a set, each the product of two lower ones.
template <PowerSet wanted>
struct Powers {
    static constexpr PowerSet set = closed(wanted);
    std::array<Lanes, highest(set) + 1> value;

    HWY_INLINE explicit Powers(Lanes x) {
        value[1] = x;
        fill<2>();
    }
    template <int power>
    [[nodiscard]] HWY_INLINE Lanes at() const {
        static_assert(contains(set, power));
        return value[power];
    }

  private:
    template <int power>
    HWY_INLINE void fill() {
        if constexpr (power <= highest(set)) {
            if constexpr (contains(set, power)) {
                constexpr int i = factor_of(set, power);
                value[power] = value[i] * value[power - i];
            }
            fill<power + 1>();
        }
    }
};

/// Coefficient of x^power of a symbol, for the adhesion numbers of the lanes, over the symbol's @p unit.
template <const Symbol& symbol, int power, int adhesion_power = 0>
[[nodiscard]] HWY_INLINE Lanes coefficient_of(Lanes adhesion, double unit) {
    constexpr bool more = [] {
        for (int j = adhesion_power + 1; j < Symbol::adhesions; ++j) {
            if (symbol.at(power, j) != 0.0) return true;
        }
        return false;
    }();
    const Lanes constant(symbol.at(power, adhesion_power) / unit);
    if constexpr (!more) {
        return constant;
    } else {
        const Lanes rest = coefficient_of<symbol, power, adhesion_power + 1>(adhesion, unit);
        if constexpr (symbol.at(power, adhesion_power) == 0.0) return rest * adhesion;
        return multiply_add(rest, adhesion, constant);
    }
}

/// A polynomial of the state, divided by its leading coefficient, on the lanes.
template <const Symbol& symbol, bool with_constant>
struct Monic {
    using Pattern = Sparse<symbol, with_constant>;
    static constexpr int count = Pattern::terms.count;
    static constexpr int stride = Pattern::terms.stride();
    static constexpr int lowest = Pattern::terms.lowest();
    std::array<Lanes, count> coefficient;  ///< that of the highest power is 1 and not used

    Monic() = default;
    HWY_INLINE explicit Monic(Lanes adhesion) { fill<1>(adhesion); }

    /// Value, from powers of x that hold Pattern::powers.
    template <PowerSet set>
    [[nodiscard]] HWY_INLINE Lanes operator()(const Powers<set>& x) const {
        if constexpr (count == 1) {
            return power<lowest>(x);
        } else if constexpr (lowest == 0) {
            return horner<count - 1>(x);
        } else {
            return x.template at<lowest>() * horner<count - 1>(x);
        }
    }
    /// c - value
    template <PowerSet set>
    [[nodiscard]] HWY_INLINE Lanes subtracted_from(Lanes c, const Powers<set>& x) const {
        if constexpr (count == 1 && lowest == 0) {
            return c - Lanes(1.0);
        } else if constexpr (count == 1 && lowest == 1) {
            return c - x.template at<1>();
        } else if constexpr (count == 1) {
            return subtract_product(c, x.template at<lowest / 2>(), x.template at<lowest - lowest / 2>());
        } else if constexpr (lowest == 0) {
            return c - horner<count - 1>(x);
        } else {
            return subtract_product(c, x.template at<lowest>(), horner<count - 1>(x));
        }
    }

  private:
    template <int i>
    HWY_INLINE void fill(Lanes adhesion) {
        if constexpr (i < count) {
            coefficient[i] = coefficient_of<symbol, Pattern::terms.at(i)>(adhesion, Pattern::leading);
            fill<i + 1>(adhesion);
        }
    }
    template <int exponent, PowerSet set>
    [[nodiscard]] HWY_INLINE static Lanes power(const Powers<set>& x) {
        if constexpr (exponent == 0) {
            return Lanes(1.0);
        } else if constexpr (contains(Powers<set>::set, exponent)) {
            return x.template at<exponent>();
        } else {
            return x.template at<exponent / 2>() * x.template at<exponent - exponent / 2>();
        }
    }
    /// The monic polynomial in x^stride down to the coefficient @p last.
    template <int last, PowerSet set>
    [[nodiscard]] HWY_INLINE Lanes horner(const Powers<set>& x) const {
        constexpr int gap = (Pattern::terms.at(last - 1) - Pattern::terms.at(last)) / stride;
        static_assert(gap == 1, "a polynomial with a gap needs the powers between");
        if constexpr (last > 1) {
            return multiply_add(horner<last - 1>(x), x.template at<stride>(), coefficient[last]);
        } else if constexpr (contains(Powers<set>::set, stride)) {
            return x.template at<stride>() + coefficient[1];
        } else {
            return multiply_add(x.template at<stride / 2>(), x.template at<stride - stride / 2>(),
                                coefficient[1]);
        }
    }
};

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
