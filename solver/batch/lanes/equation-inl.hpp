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

#include <hwy/highway.h>

#include "solver/batch/lanes/form.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Mask = hn::Mask<Tag>;
inline constexpr std::size_t lane_count = hn::MaxLanes(Tag());

#ifdef ASHIMPACT_COUNT_OPERATIONS  // bench/operations.cpp
inline long operation_count = 0;
#endif

/// One number of each lane of a vector register; a number type to the contact laws.
struct Lanes {
    hn::Vec<Tag> v;

    Lanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix with lanes
    HWY_INLINE Lanes(double x) : v(hn::Set(Tag(), x)) {}
    HWY_INLINE explicit Lanes(hn::Vec<Tag> x) : v(x) {}

    HWY_INLINE static Lanes load(const double* from) { return Lanes(hn::LoadU(Tag(), from)); }
    HWY_INLINE void store(double* to) const { hn::StoreU(v, Tag(), to); }

    HWY_INLINE friend Lanes operator+(Lanes a, Lanes b) { return counted(hn::Add(a.v, b.v)); }
    HWY_INLINE friend Lanes operator-(Lanes a, Lanes b) { return counted(hn::Sub(a.v, b.v)); }
    HWY_INLINE friend Lanes operator*(Lanes a, Lanes b) { return counted(hn::Mul(a.v, b.v)); }
    HWY_INLINE friend Lanes operator-(Lanes a) { return counted(hn::Neg(a.v)); }
    /// a b + c
    HWY_INLINE friend Lanes multiply_add(Lanes a, Lanes b, Lanes c) {
        return counted(hn::MulAdd(a.v, b.v, c.v));
    }
    /// c - a b
    HWY_INLINE friend Lanes subtract_product(Lanes c, Lanes a, Lanes b) {
        return counted(hn::NegMulAdd(a.v, b.v, c.v));
    }
    HWY_INLINE friend Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
    HWY_INLINE friend Lanes abs(Lanes a) { return Lanes(hn::Abs(a.v)); }
    HWY_INLINE friend Lanes sqrt(Lanes a) { return Lanes(hn::Sqrt(a.v)); }
    HWY_INLINE friend Lanes min(Lanes a, Lanes b) { return Lanes(hn::Min(a.v, b.v)); }
    HWY_INLINE friend Lanes max(Lanes a, Lanes b) { return Lanes(hn::Max(a.v, b.v)); }
    HWY_INLINE friend Mask operator<(Lanes a, Lanes b) { return hn::Lt(a.v, b.v); }
    HWY_INLINE friend Mask operator>(Lanes a, Lanes b) { return hn::Gt(a.v, b.v); }
    HWY_INLINE friend Mask operator<=(Lanes a, Lanes b) { return hn::Le(a.v, b.v); }
    HWY_INLINE friend Mask operator>=(Lanes a, Lanes b) { return hn::Ge(a.v, b.v); }
    HWY_INLINE friend Lanes select(Mask mask, Lanes yes, Lanes no) {
        return Lanes(hn::IfThenElse(mask, yes.v, no.v));
    }

  private:
    HWY_INLINE static Lanes counted(hn::Vec<Tag> result) {
#ifdef ASHIMPACT_COUNT_OPERATIONS
        ++operation_count;
#endif
        return Lanes(result);
    }
};

HWY_INLINE Mask both(Mask a, Mask b) {
    return hn::And(a, b);
}
HWY_INLINE Mask either(Mask a, Mask b) {
    return hn::Or(a, b);
}
/// a and not b
HWY_INLINE Mask without(Mask a, Mask b) {
    return hn::AndNot(b, a);
}
HWY_INLINE Mask none() {
    return hn::FirstN(Tag(), 0);
}
HWY_INLINE Mask every() {
    return hn::FirstN(Tag(), lane_count);
}
HWY_INLINE bool any(Mask mask) {
    return !hn::AllFalse(Tag(), mask);
}

/// Binary logarithm, linear between the powers of two: off by at most 0.086, and inverted exactly by
/// rough_exp2(); for finite x > 0.
HWY_INLINE Lanes rough_log2(Lanes x) {
    const hn::RebindToSigned<Tag> integers;
    const Lanes bits(hn::ConvertTo(Tag(), hn::BitCast(integers, x.v)));
    return multiply_add(bits, 0x1p-52, -1023.0);
}
/// Inverse of rough_log2(), for -1022 < x < 1024.
HWY_INLINE Lanes rough_exp2(Lanes x) {
    const hn::RebindToSigned<Tag> integers;
    const Lanes bits = (x + Lanes(1023.0)) * Lanes(0x1p52);
    return Lanes(hn::BitCast(Tag(), hn::ConvertTo(integers, bits.v)));
}

/// x^(-1/degree) of a normal x > 0 by Newton's iteration, which needs no division; to rounding.
template <int degree>
HWY_INLINE Lanes inverse_root(Lanes x) {
    Lanes y = rough_exp2((rough_log2(x) + Lanes(0.043)) * Lanes(-1.0 / degree));
    const Lanes scaled = x * Lanes(1.0 / degree);
    for (int i = 0; i < 5; ++i) {
        Lanes power = y;
        for (int k = 1; k < degree; ++k) power = power * y;
        // y (1 + (1 - x y^degree)/degree)
        y = multiply_add(y, subtract_product(Lanes(1.0 / degree), scaled, power), y);
    }
    return y;
}

/// Cube root of x >= 0, to rounding; 0 for x below the normal numbers.
HWY_INLINE Lanes cbrt(Lanes x) {
    const Lanes y = inverse_root<3>(max(x, 1e-300));
    return x * y * y;
}

/// x^(2/5) of x > 0, to rounding.
HWY_INLINE Lanes two_fifths_power(Lanes x) {
    const Lanes y = inverse_root<5>(x);
    return x * y * y * y;
}

/// Lanes in memory: the number type with which a contact law is evaluated outside the integration. The
/// functions of a law are compiled for the baseline, so wider registers cannot be passed to them; memory can.
struct LaneNumber {
    HWY_ALIGN double value[lane_count];

    LaneNumber() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix with lanes
    LaneNumber(double x) { Lanes(x).store(value); }
    explicit LaneNumber(const Lanes& x) { x.store(value); }

    [[nodiscard]] HWY_INLINE Lanes lanes() const { return Lanes::load(value); }
};

// No friends: GCC 12 compiles some of those for the baseline.
inline LaneNumber operator+(const LaneNumber& a, const LaneNumber& b) {
    return LaneNumber(a.lanes() + b.lanes());
}
inline LaneNumber operator-(const LaneNumber& a, const LaneNumber& b) {
    return LaneNumber(a.lanes() - b.lanes());
}
inline LaneNumber operator*(const LaneNumber& a, const LaneNumber& b) {
    return LaneNumber(a.lanes() * b.lanes());
}
inline LaneNumber operator/(const LaneNumber& a, const LaneNumber& b) {
    return LaneNumber(a.lanes() / b.lanes());
}
inline LaneNumber operator-(const LaneNumber& a) {
    return LaneNumber(-a.lanes());
}
inline LaneNumber max(const LaneNumber& a, const LaneNumber& b) {
    return LaneNumber(max(a.lanes(), b.lanes()));
}
inline LaneNumber sqrt(const LaneNumber& x) {
    return LaneNumber(sqrt(x.lanes()));
}
inline LaneNumber cbrt(const LaneNumber& x) {
    return LaneNumber(cbrt(x.lanes()));
}
inline LaneNumber two_fifths_power(const LaneNumber& x) {
    return LaneNumber(two_fifths_power(x.lanes()));
}

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

/// The numbers of a contact law in the lanes, as NumberPolynomial has them.
struct LawNumbers {
    Lanes adhesion;
    Lanes offset;

    LawNumbers() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): most laws have this number alone
    HWY_INLINE LawNumbers(Lanes adhesion_number, Lanes force_offset = 0.0)
        : adhesion(adhesion_number), offset(force_offset) {}
};

/// Whether a coefficient of a symbol has one of the numbers' powers from @p first to before @p last.
template <const Symbol& symbol, int power>
[[nodiscard]] constexpr bool has_numbers(int first, int last) {
    for (int j = first; j < last; ++j)
        if (symbol[power][j] != 0.0) return true;
    return false;
}
/// The part of coefficient_of() without the offset, or the factor of the offset.
template <const Symbol& symbol, int power, int number_power>
[[nodiscard]] HWY_INLINE Lanes adhesion_part(Lanes adhesion, double unit) {
    constexpr int end = (number_power / powers_of_adhesion + 1) * powers_of_adhesion;
    const Lanes constant(symbol[power][number_power] / unit);
    if constexpr (!has_numbers<symbol, power>(number_power + 1, end)) {
        return constant;
    } else {
        const Lanes rest = adhesion_part<symbol, power, number_power + 1>(adhesion, unit);
        if constexpr (symbol[power][number_power] == 0.0) return rest * adhesion;
        return multiply_add(rest, adhesion, constant);
    }
}
/// Coefficient of x^power of a symbol, for the numbers of the lanes, over the symbol's @p unit.
template <const Symbol& symbol, int power>
[[nodiscard]] HWY_INLINE Lanes coefficient_of(const LawNumbers& numbers, double unit) {
    constexpr int next = powers_of_adhesion;
    const Lanes part = adhesion_part<symbol, power, 0>(numbers.adhesion, unit);
    if constexpr (!has_numbers<symbol, power>(next, NumberPolynomial::capacity)) return part;
    return multiply_add(adhesion_part<symbol, power, next>(numbers.adhesion, unit), numbers.offset, part);
}

/// A polynomial of the state, divided by its leading coefficient, on the lanes.
template <const Symbol& symbol, bool with_constant>
struct Monic {
    using Pattern = Sparse<symbol, with_constant>;
    static constexpr int count = Pattern::terms.count;
    static constexpr int lowest = Pattern::terms.lowest();
    std::array<Lanes, count> coefficient;  ///< that of the highest power is 1 and not used

    Monic() = default;
    HWY_INLINE explicit Monic(const LawNumbers& numbers) { fill<1>(numbers); }

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
    HWY_INLINE void fill(const LawNumbers& numbers) {
        if constexpr (i < count) {
            coefficient[i] = coefficient_of<symbol, Pattern::terms.at(i)>(numbers, Pattern::leading);
            fill<i + 1>(numbers);
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
    /// The monic polynomial over the power of the coefficient @p last, down to that.
    template <int last, PowerSet set>
    [[nodiscard]] HWY_INLINE Lanes horner(const Powers<set>& x) const {
        constexpr int gap = Pattern::terms.at(last - 1) - Pattern::terms.at(last);
        if constexpr (last > 1) {
            return multiply_add(horner<last - 1>(x), x.template at<gap>(), coefficient[last]);
        } else if constexpr (contains(Powers<set>::set, gap)) {
            return x.template at<gap>() + coefficient[1];
        } else {
            return multiply_add(x.template at<gap / 2>(), x.template at<gap - gap / 2>(), coefficient[1]);
        }
    }
};

/// Value of a symbol at @p x for the numbers of the lanes.
template <const Symbol& symbol>
[[nodiscard]] HWY_INLINE Lanes value_of(const LawNumbers& numbers, Lanes x) {
    using Polynomial = Monic<symbol, true>;
    const Powers<Polynomial::Pattern::powers> powers(x);
    return Lanes(Polynomial::Pattern::leading) * Polynomial(numbers)(powers);
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

/// The equation of motion of Form, for the numbers of the lanes. ZoneForm has its own;
/// what follows the motion of either uses the members that both have.
template <class F>
struct Equation {
    using Stiffness = Monic<F::stiffness, true>;
    using Impulse = Monic<F::impulse, true>;
    using Slope = Monic<F::slope, false>;
    static constexpr PowerSet powers =
        closed(Stiffness::Pattern::powers | Impulse::Pattern::powers | Slope::Pattern::powers);

    LawNumbers numbers;
    Lanes damping;
    Stiffness stiffness;
    Impulse impulse;
    Slope slope;
    Lanes slope_constant;  ///< delta'(0), which slope leaves out

    Equation() = default;
    HWY_INLINE Equation(const LawNumbers& law_numbers, Lanes damping_number)
        : numbers(law_numbers),
          damping(damping_number),
          stiffness(law_numbers),
          impulse(law_numbers),
          slope(law_numbers),
          slope_constant(coefficient_of<F::slope, 0>(law_numbers, 1.0)) {}

    /// What kicked(), impulse_at() and slope_at() need of a state: they are evaluated together. Each is a
    /// monic polynomial, over its unit.
    using At = Powers<powers>;
    /// At a distance from q.
    [[nodiscard]] HWY_INLINE At at(Lanes q, Lanes distance) const { return At(q + distance); }
    /// c - h
    [[nodiscard]] HWY_INLINE Lanes kicked(Lanes c, const At& x) const {
        return stiffness.subtracted_from(c, x);
    }
    [[nodiscard]] HWY_INLINE Lanes impulse_at(const At& x) const { return impulse(x); }
    [[nodiscard]] HWY_INLINE Lanes slope_at(const At& x) const { return slope(x); }
    [[nodiscard]] HWY_INLINE static Lanes kick_unit() { return Stiffness::Pattern::leading; }
    [[nodiscard]] HWY_INLINE static Lanes impulse_unit() { return Impulse::Pattern::leading; }
    [[nodiscard]] HWY_INLINE static Lanes slope_unit() { return Slope::Pattern::leading; }
    /// Of the estimates of a step's error.
    [[nodiscard]] HWY_INLINE static Lanes error_weight() { return F::Damping::error_weight; }
    /// Makes the equation ready for steps from a state.
    HWY_INLINE void prepare(Lanes /*q*/, Mask /*lanes*/, Mask /*inward*/) {}
    /// The longest step from a state over which the equation is known.
    [[nodiscard]] HWY_INLINE static Lanes longest_step(Lanes /*q*/, Lanes /*v*/, Lanes /*acceleration*/,
                                                       Lanes step) {
        return step;
    }
    /// Whether a state is within what the equation knows of.
    [[nodiscard]] HWY_INLINE static Mask knows(Lanes /*q*/) { return every(); }

    /// beta g(q)
    [[nodiscard]] HWY_INLINE Lanes damping_impulse(Lanes q) const {
        return damping * value_of<F::impulse>(numbers, q);
    }
    /// v = d(delta)/dt
    [[nodiscard]] HWY_INLINE Lanes velocity(const LaneState& state) const {
        return state.momentum - damping_impulse(state.position);
    }
    [[nodiscard]] HWY_INLINE Lanes potential(Lanes q) const { return value_of<F::potential>(numbers, q); }
    [[nodiscard]] HWY_INLINE Lanes overlap(Lanes q) const { return value_of<F::overlap>(numbers, q); }
    [[nodiscard]] HWY_INLINE Lanes force(Lanes q) const { return value_of<F::force>(numbers, q); }
    [[nodiscard]] HWY_INLINE Lanes force_slope(Lanes q) const { return value_of<F::force_slope>(numbers, q); }
    /// delta'(q)
    [[nodiscard]] HWY_INLINE Lanes slope_of(Lanes q) const { return value_of<F::slope>(numbers, q); }
    /// eta(q)
    [[nodiscard]] HWY_INLINE Lanes damping_at(Lanes q) const {
        return damping * value_of<F::damping_of_state>(numbers, q);
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
