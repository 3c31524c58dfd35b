// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/problems.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/range_lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// How many values are in a range, in steps of a few registers, until the first step with one that is not.
std::size_t steps_within(const batch::Range& range, const double* values, std::size_t count) {
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::ScalableTag<double> d;
    constexpr std::size_t registers = 4;  // with one branch for all of them
    const auto least = hn::Set(d, range.least);
    const auto greatest = hn::Set(d, range.greatest);
    const auto other = hn::Set(d, range.or_zero ? 0.0 : range.least);
    const auto within = [&](std::size_t i) HWY_ATTR {
        const auto value = hn::LoadU(d, values + i);
        return hn::Or(hn::And(hn::Ge(value, least), hn::Le(value, greatest)), hn::Eq(value, other));
    };
    const std::size_t width = hn::Lanes(d);
    std::size_t i = 0;
    for (; i + registers * width <= count; i += registers * width) {
        const auto first = hn::And(within(i), within(i + width));
        const auto second = hn::And(within(i + 2 * width), within(i + 3 * width));
        if (!hn::AllTrue(d, hn::And(first, second))) break;
    }
    return i;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(steps_within);

std::size_t batch::count_within(const Range& range, const double* values, std::size_t count) {
    std::size_t i = HWY_DYNAMIC_DISPATCH(steps_within)(range, values, count);
    while (i < count && range.holds(values[i])) ++i;
    return i;
}

}  // namespace ashimpact
#endif
