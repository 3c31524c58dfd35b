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

/// One number of each lane of a vector register; a number type to the contact laws.
struct Lanes {
    hn::Vec<Tag> v;

    Lanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix with lanes
    HWY_INLINE Lanes(double x) : v(hn::Set(Tag(), x)) {}
    HWY_INLINE explicit Lanes(hn::Vec<Tag> x) : v(x) {}

    HWY_INLINE static Lanes load(const double* from) { return Lanes(hn::LoadU(Tag(), from)); }
    HWY_INLINE void store(double* to) const { hn::StoreU(v, Tag(), to); }
};

#ifdef ASHIMPACT_COUNT_OPERATIONS  // bench/operations.cpp
inline long operation_count = 0;
HWY_INLINE void count_operation() {
    ++operation_count;
}
#else
HWY_INLINE void count_operation() {}
#endif

HWY_INLINE Lanes operator+(Lanes a, Lanes b) {
    count_operation();
    return Lanes(hn::Add(a.v, b.v));
}
HWY_INLINE Lanes operator-(Lanes a, Lanes b) {
    count_operation();
    return Lanes(hn::Sub(a.v, b.v));
}
HWY_INLINE Lanes operator*(Lanes a, Lanes b) {
    count_operation();
    return Lanes(hn::Mul(a.v, b.v));
}
HWY_INLINE Lanes operator/(Lanes a, Lanes b) {
    return Lanes(hn::Div(a.v, b.v));
}
HWY_INLINE Lanes operator-(Lanes a) {
    count_operation();
    return Lanes(hn::Neg(a.v));
}
HWY_INLINE Mask operator<(Lanes a, Lanes b) {
    return hn::Lt(a.v, b.v);
}
HWY_INLINE Mask operator>(Lanes a, Lanes b) {
    return hn::Gt(a.v, b.v);
}
HWY_INLINE Mask operator<=(Lanes a, Lanes b) {
    return hn::Le(a.v, b.v);
}
HWY_INLINE Mask operator>=(Lanes a, Lanes b) {
    return hn::Ge(a.v, b.v);
}

/// a b + c
HWY_INLINE Lanes multiply_add(Lanes a, Lanes b, Lanes c) {
    count_operation();
    return Lanes(hn::MulAdd(a.v, b.v, c.v));
}
/// c - a b
HWY_INLINE Lanes subtract_product(Lanes c, Lanes a, Lanes b) {
    count_operation();
    return Lanes(hn::NegMulAdd(a.v, b.v, c.v));
}
HWY_INLINE Lanes abs(Lanes a) {
    return Lanes(hn::Abs(a.v));
}
HWY_INLINE Lanes sqrt(Lanes a) {
    return Lanes(hn::Sqrt(a.v));
}
HWY_INLINE Lanes min(Lanes a, Lanes b) {
    return Lanes(hn::Min(a.v, b.v));
}
HWY_INLINE Lanes max(Lanes a, Lanes b) {
    return Lanes(hn::Max(a.v, b.v));
}
HWY_INLINE Lanes select(Mask mask, Lanes yes, Lanes no) {
    return Lanes(hn::IfThenElse(mask, yes.v, no.v));
}

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

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
