#include "solver/statistics/histogram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace ashimpact {

namespace {

constexpr unsigned stored_digits = std::numeric_limits<double>::digits - 1;

}  // namespace

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
    std::vector<std::uint32_t> numbers(values.size());
    std::size_t positive = 0;
    std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t highest = 0;
    for (const double value : values) {  // without branches, which captures among rebounds would make costly
        const bool counts = value > 0;
        const std::uint32_t bin = bins.bin_of(counts ? value : 1.0);
        numbers[positive] = bin;
        positive += counts ? 1 : 0;
        zeros_ += value == 0 ? 1 : 0;
        lowest = counts ? std::min(lowest, bin) : lowest;
        highest = counts ? std::max(highest, bin) : highest;
    }
    if (positive == 0) return;
    cover(lowest, highest);
    for (std::size_t i = 0; i < positive; ++i) ++counts_[numbers[i] - first_];
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

std::uint64_t Histogram::total() const {
    return std::accumulate(counts_.begin(), counts_.end(), zeros_);
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
