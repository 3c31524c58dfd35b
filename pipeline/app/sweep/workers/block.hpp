// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/app/sweep/spec/plan.hpp"
#include "solver/statistics/histogram.hpp"
#include "solver/statistics/moments.hpp"
#include "solver/statistics/propagation.hpp"

namespace ashimpact {

/// 2^level consecutive chunks, the first of which is a multiple of 2^level: a node of the tree in which
/// chunks are merged, and the work that one thread does at a time.
struct Block {
    std::uint64_t first = 0;
    unsigned level = 0;

    [[nodiscard]] std::uint64_t chunks() const { return std::uint64_t{1} << level; }
    void transfer(auto& archive) { archive(first, level); }
};

/// Sums over impacts of one law, by observable and by group of points. Floating-point: their order matters.
struct LawSums {
    std::vector<std::vector<Moments>> observables;
    std::vector<std::vector<SobolSums>> sensitivity;

    void merge(const LawSums& other);
    void transfer(auto& archive) { archive(observables, sensitivity); }
};

struct SweepSums {
    std::vector<LawSums> laws;

    void merge(const SweepSums& other);
    void transfer(auto& archive) { archive(laws); }
};

/// Counts of impacts by law and observable. Integers: their order does not matter.
using SweepCounts = std::vector<std::vector<Histogram>>;

/// Impacts of a sweep that did not converge: their number for each law, and the first of them in detail.
struct FailedImpacts {
    static constexpr std::size_t most_listed = 100;

    struct Listed {
        std::uint64_t law;  ///< index among the laws of the sweep
        std::uint64_t row;  ///< of the full table
        std::string reason;
        std::string command;  ///< shell command that computes this impact alone

        void transfer(auto& archive) { archive(law, row, reason, command); }
    };
    std::vector<std::uint64_t> counts;  ///< by law
    std::vector<Listed> listed;

    [[nodiscard]] std::uint64_t total() const;
    void merge(const FailedImpacts& other);
    void transfer(auto& archive) { archive(counts, listed); }
};

/// Results of a block.
struct BlockResult {
    SweepSums sums;
    SweepCounts counts;
    FailedImpacts failed;
    std::string rows;  ///< of the full table, packed chunk by chunk

    void transfer(auto& archive) { archive(sums, counts, failed, rows); }
};

/// Computes a block. The result depends only on the plan and the block.
[[nodiscard]] BlockResult compute_block(const SweepPlan& plan, const ImpactSolver& solver,
                                        const Block& block);

/// Merged results of all chunks before some chunk. Its size does not depend on their number.
struct SweepProgress {
    std::uint64_t chunks = 0;
    PairwiseMerge<SweepSums> sums;
    SweepCounts counts;
    FailedImpacts failed;
    std::uint64_t row_bytes = 0;  ///< of their packed rows

    /// Adds the next block, which begins at chunk `chunks`; its rows are up to the caller.
    void add(const Block& block, BlockResult result);
    void transfer(auto& archive) { archive(chunks, sums, counts, failed, row_bytes); }
};

}  // namespace ashimpact
