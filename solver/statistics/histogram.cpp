// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/histogram.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/statistics/histogram.cpp"
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

constexpr unsigned stored_digits = std::numeric_limits<double>::digits - 1;

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

double Bins::resolution() const {
    return is_relative() ? std::ldexp(1.0, -static_cast<int>(digits_)) : 1.0 / count_;
}

std::uint32_t Bins::bin_of(double value) const {
    if (is_relative())
        return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(value) >> (stored_digits - digits_));
    return static_cast<std::uint32_t>(std::min(value * count_, static_cast<double>(count_ - 1)));
}

double Bins::edge(std::uint32_t bin) const {
    if (is_relative()) return std::bit_cast<double>(std::uint64_t{bin} << (stored_digits - digits_));
    return static_cast<double>(bin) / count_;
}

void Histogram::count(const Bins& bins, std::span<const double> values) {
    constexpr std::size_t together = 512;
    const PositiveRange range = positive_range(values);
    zeros_ += range.zeros;
    if (range.positive == 0) return;
    const std::uint32_t highest = bins.bin_of(range.greatest);
    cover(bins.bin_of(range.least), highest);
    std::array<std::uint32_t, together> numbers;  // find_bins() fills what is used
    for (std::size_t first = 0; first < values.size(); first += together) {
        const std::size_t size = std::min(together, values.size() - first);
        find_bins(bins, values.subspan(first, size), range.greatest, numbers.data());
        for (std::size_t i = 0; i < size; ++i) ++counts_[numbers[i] - first_];
    }
    counts_[highest - first_] -= values.size() - range.positive;  // the others were counted as the greatest
}

void Histogram::add_ones(std::uint64_t ones, std::uint64_t zeros) {
    zeros_ += zeros;
    if (ones == 0) return;
    cover(0, 0);
    counts_.front() += ones;
}

void Histogram::merge(const Histogram& other) {
    zeros_ += other.zeros_;
    if (other.counts_.empty()) return;
    cover(other.first_, other.first_ + static_cast<std::uint32_t>(other.counts_.size()) - 1);
    const std::size_t offset = other.first_ - first_;
    for (std::size_t i = 0; i < other.counts_.size(); ++i) counts_[offset + i] += other.counts_[i];
}

void Histogram::cover(std::uint32_t lowest, std::uint32_t highest) {
    if (counts_.empty()) first_ = lowest;
    if (lowest < first_) {
        counts_.insert(counts_.begin(), first_ - lowest, 0);
        first_ = lowest;
    }
    if (highest - first_ >= counts_.size()) counts_.resize(highest - first_ + 1, 0);
}

QuantileBounds Histogram::quantile(const Bins& bins, double probability) const {
    const double rank = std::ceil(probability * static_cast<double>(total()));
    auto left = static_cast<std::uint64_t>(std::max(rank, 1.0));
    if (left <= zeros_) return {0, 0};
    left -= zeros_;
    std::uint32_t bin = first_;
    for (const std::uint64_t in_bin : counts_) {
        if (left <= in_bin) break;
        left -= in_bin;
        ++bin;
    }
    return {bins.edge(bin), bins.edge(bin + 1)};
}

}  // namespace ashimpact
#endif
