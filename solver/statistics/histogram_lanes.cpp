// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "solver/statistics/histogram.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/statistics/histogram_lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Lanes = hn::Vec<Tag>;

}  // namespace

/// The range of as many values as whole registers hold. @return how many values those are
std::size_t range_of_lanes(const double* values, std::size_t count, PositiveRange& range) {
    const Tag d;
    const std::size_t width = hn::Lanes(d);
    const Lanes zero = hn::Zero(d);
    const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    Lanes least = infinity;
    Lanes greatest = zero;
    std::size_t i = 0;
    for (; i + width <= count; i += width) {
        const Lanes value = hn::LoadU(d, values + i);
        const auto counts = hn::Gt(value, zero);
        range.zeros += hn::CountTrue(d, hn::Eq(value, zero));
        range.positive += hn::CountTrue(d, counts);
        least = hn::Min(least, hn::IfThenElse(counts, value, infinity));
        greatest = hn::Max(greatest, hn::IfThenElseZero(counts, value));
    }
    range.least = hn::GetLane(hn::MinOfLanes(d, least));
    range.greatest = hn::GetLane(hn::MaxOfLanes(d, greatest));
    return i;
}

/// Bins of constant width for as many values as whole registers hold. @return how many values those are
std::size_t find_absolute(double count_of_bins, const double* values, std::size_t count, double otherwise,
                          std::uint32_t* numbers) {
    const Tag d;
    const hn::Rebind<std::int32_t, Tag> integers;
    const hn::Rebind<std::uint32_t, Tag> naturals;
    const std::size_t width = hn::Lanes(d);
    std::size_t i = 0;
    for (; i + width <= count; i += width) {
        const Lanes value = hn::LoadU(d, values + i);
        const Lanes counted = hn::IfThenElse(hn::Gt(value, hn::Zero(d)), value, hn::Set(d, otherwise));
        const Lanes place =
            hn::Min(hn::Mul(counted, hn::Set(d, count_of_bins)), hn::Set(d, count_of_bins - 1));
        hn::StoreU(hn::BitCast(naturals, hn::DemoteTo(integers, place)), naturals, numbers + i);
    }
    return i;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

namespace {

HWY_EXPORT(range_of_lanes);
HWY_EXPORT(find_absolute);

}  // namespace

PositiveRange positive_range(std::span<const double> values) {
    PositiveRange range{0, 0, std::numeric_limits<double>::infinity(), 0};
    std::size_t i = HWY_DYNAMIC_DISPATCH(range_of_lanes)(values.data(), values.size(), range);
    for (; i < values.size(); ++i) {
        const double value = values[i];
        if (value == 0) ++range.zeros;
        if (!(value > 0)) continue;
        ++range.positive;
        range.least = std::min(range.least, value);
        range.greatest = std::max(range.greatest, value);
    }
    return range;
}

void find_bins(const Bins& bins, std::span<const double> values, double otherwise, std::uint32_t* numbers) {
    std::size_t i = 0;
    constexpr std::uint32_t most = std::numeric_limits<std::int32_t>::max();
    if (!bins.is_relative() && bins.count() <= most)
        i = HWY_DYNAMIC_DISPATCH(find_absolute)(bins.count(), values.data(), values.size(), otherwise,
                                                numbers);
    for (; i < values.size(); ++i) numbers[i] = bins.bin_of(values[i] > 0 ? values[i] : otherwise);
}

}  // namespace ashimpact
#endif
