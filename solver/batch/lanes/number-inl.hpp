// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_NUMBER_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_NUMBER_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_NUMBER_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_NUMBER_INL_HPP
#endif

#include "solver/batch/lanes/roots-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

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
