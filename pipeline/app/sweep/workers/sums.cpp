// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/workers/sums.hpp"

#include <numeric>

namespace ashimpact {

namespace {

/// Merges element by element; an empty list takes the other as it is.
template <class Sums>
void merge_each(std::vector<Sums>& sums, const std::vector<Sums>& others) {
    if (sums.empty()) sums.resize(others.size());
    for (std::size_t i = 0; i < others.size(); ++i) sums[i].merge(others[i]);
}

template <class Sums>
void merge_each(std::vector<std::vector<Sums>>& sums, const std::vector<std::vector<Sums>>& others) {
    if (sums.empty()) sums.resize(others.size());
    for (std::size_t i = 0; i < others.size(); ++i) merge_each(sums[i], others[i]);
}

}  // namespace

void LawSums::merge(const LawSums& other) {
    merge_each(observables, other.observables);
    merge_each(sensitivity, other.sensitivity);
}

void SweepSums::merge(const SweepSums& other) {
    merge_each(laws, other.laws);
}

std::uint64_t FailedImpacts::total() const {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void FailedImpacts::merge(const FailedImpacts& other) {
    if (counts.empty()) counts.resize(other.counts.size());
    for (std::size_t i = 0; i < other.counts.size(); ++i) counts[i] += other.counts[i];
    for (const Listed& each : other.listed)
        if (listed.size() < most_listed) listed.push_back(each);
}

void SweepCounts::merge(const SweepCounts& other) {
    merge_each(laws, other.laws);
}

}  // namespace ashimpact
