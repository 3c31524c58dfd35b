// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_LANES_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_LANES_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_LANES_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

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
inline LaneNumber sqrt(const LaneNumber& x) {
    return LaneNumber(sqrt(x.lanes()));
}
inline LaneNumber cbrt(const LaneNumber& x) {
    return LaneNumber(cbrt(x.lanes()));
}
inline LaneNumber two_fifths_power(const LaneNumber& x) {
    return LaneNumber(two_fifths_power(x.lanes()));
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
