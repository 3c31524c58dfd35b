#include "pipeline/sweep/crew/sums.hpp"

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

void SweepCounts::merge(const SweepCounts& other) {
    merge_each(laws, other.laws);
}

}  // namespace ashimpact
