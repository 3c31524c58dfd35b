// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/statistics/histogram.hpp"
#include "solver/statistics/propagation.hpp"

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

/// Impacts of a sweep that did not converge: their number for each law, and the first of them in detail.
struct FailedImpacts {
    static constexpr std::size_t most_listed = 100;

    struct Listed {
        std::uint64_t law;  ///< index among the laws of the sweep
        std::uint64_t row;  ///< of the full table
        std::string reason;
        std::string command;  ///< shell command that computes this impact alone

        template <class Archive>
        void transfer(Archive& archive) {
            archive(law, row, reason, command);
        }
    };
    std::vector<std::uint64_t> counts;  ///< by law
    std::vector<Listed> listed;

    [[nodiscard]] std::uint64_t total() const;
    void merge(const FailedImpacts& other);

    template <class Archive>
    void transfer(Archive& archive) {
        archive(counts, listed);
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
