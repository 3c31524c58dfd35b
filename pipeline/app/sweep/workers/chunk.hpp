// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/app/sweep/spec/plan.hpp"
#include "pipeline/app/sweep/workers/sums.hpp"
#include "solver/statistics/moments.hpp"

namespace ashimpact {

/// 2^level consecutive chunks, the first of which is a multiple of 2^level: a node of the tree in which
/// chunks are merged, and the work that one thread does at a time.
struct Block {
    std::uint64_t first = 0;
    unsigned level = 0;

    [[nodiscard]] std::uint64_t chunks() const { return std::uint64_t{1} << level; }

    template <class Archive>
    void transfer(Archive& archive) {
        archive(first, level);
    }
};

/// Results of a block.
struct BlockResult {
    SweepSums sums;
    SweepCounts counts;
    FailedImpacts failed;
    std::string rows;  ///< of the full table, packed chunk by chunk

    template <class Archive>
    void transfer(Archive& archive) {
        archive(sums, counts, failed, rows);
    }
};

/// Computes a block. The result depends only on the plan and the block.
[[nodiscard]] BlockResult compute_block(const SweepPlan& plan, const ImpactSolver& solver,
                                        const Block& block);

}  // namespace ashimpact
