#pragma once

#include <vector>

#include "solver/statistics/histogram.hpp"
#include "solver/statistics/sensitivity.hpp"

namespace ashimpact {

/// Sums over impacts of one law, by observable and by group of points. Floating-point: their order matters.
struct LawSums {
    std::vector<std::vector<Moments>> observables;
    std::vector<std::vector<SobolSums>> sensitivity;

    void merge(const LawSums& other);

    template <class Archive>
    void transfer(Archive& archive) {
        archive(observables, sensitivity);
    }
};

struct SweepSums {
    std::vector<LawSums> laws;

    void merge(const SweepSums& other);

    template <class Archive>
    void transfer(Archive& archive) {
        archive(laws);
    }
};

/// Counts of impacts by law and observable. Integers: their order does not matter.
struct SweepCounts {
    std::vector<std::vector<Histogram>> laws;

    void merge(const SweepCounts& other);

    template <class Archive>
    void transfer(Archive& archive) {
        archive(laws);
    }
};

}  // namespace ashimpact
