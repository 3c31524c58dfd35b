// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/sensitivity.hpp"

#include <cmath>

namespace ashimpact {

namespace {

void add(std::vector<double>& sums, const std::vector<double>& other) {
    if (sums.empty()) sums.resize(other.size(), 0.0);
    for (std::size_t i = 0; i < other.size(); ++i) sums[i] += other[i];
}

/// Estimates without errors. The mean of f(b) is subtracted from each product: that does not change the
/// expectation, and removes the noise that a mean far from zero adds.
std::vector<SobolIndices> estimates(const SobolSums& sums) {
    const auto values = static_cast<double>(sums.values.count);
    const double points = values / 2;
    const double variance = sums.values.second / values;
    std::vector<SobolIndices> indices;
    if (!(variance > 0)) return indices;
    for (std::size_t i = 0; i < sums.first.size(); ++i)
        indices.push_back(
            {.first = (sums.first[i] - sums.values.mean * sums.difference[i]) / (points * variance),
             .total = sums.total[i] / (2 * points * variance)});
    return indices;
}

SobolSums merged_without(std::span<const SobolSums> groups, std::size_t left_out) {
    SobolSums sums;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (g != left_out) sums.merge(groups[g]);
    return sums;
}

/// Standard error from estimates that each leave out one group: sqrt((g - 1)/g sum (x - mean)^2).
double jackknife_error(const std::vector<std::vector<SobolIndices>>& partial, std::size_t variable,
                       double SobolIndices::*index) {
    std::vector<double> values;
    values.reserve(partial.size());
    for (const auto& each : partial) values.push_back(each[variable].*index);
    const Moments moments = Moments::of(values);
    return std::sqrt(moments.second * static_cast<double>(values.size() - 1) /
                     static_cast<double>(values.size()));
}

}  // namespace

SobolSums SobolSums::of(const SensitivityValues& values) {
    SobolSums sums;
    const std::span<const double> a = values.a;
    const std::span<const double> b = values.b;
    const std::size_t points = a.size();
    sums.values = Moments::of(a);
    sums.values.merge(Moments::of(b));
    for (const auto& ab : values.mixed) {
        const auto change = [&](std::size_t i) { return ab[i] - a[i]; };
        sums.first.push_back(pairwise_sum(0, points, [&](std::size_t i) { return b[i] * change(i); }));
        sums.difference.push_back(pairwise_sum(0, points, change));
        sums.total.push_back(pairwise_sum(0, points, [&](std::size_t i) { return change(i) * change(i); }));
    }
    return sums;
}

void SobolSums::merge(const SobolSums& other) {
    values.merge(other.values);
    add(first, other.first);
    add(difference, other.difference);
    add(total, other.total);
}

std::vector<SobolIndices> sobol_indices(std::span<const SobolSums> groups) {
    std::vector<SobolIndices> indices = estimates(merged_without(groups, groups.size()));
    if (groups.size() < 2) return indices;
    std::vector<std::vector<SobolIndices>> partial;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        partial.push_back(estimates(merged_without(groups, g)));
        if (partial.back().empty()) return indices;
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i].first_error = jackknife_error(partial, i, &SobolIndices::first);
        indices[i].total_error = jackknife_error(partial, i, &SobolIndices::total);
    }
    return indices;
}

}  // namespace ashimpact
