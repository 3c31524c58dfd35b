// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/app/sweep/workers/chunk.hpp"

namespace ashimpact {

/// Merged results of all chunks before some chunk. Its size does not depend on their number.
class SweepProgress {
  public:
    /// Adds the next block, which begins at chunk chunks().
    void add(const Block& block, BlockResult result) {
        sums_.add(std::move(result.sums), block.level);
        counts_.merge(result.counts);
        failed_.merge(result.failed);
        chunks_ += block.chunks();
    }

    [[nodiscard]] std::uint64_t chunks() const { return chunks_; }
    [[nodiscard]] SweepSums sums() const { return sums_.total(); }
    [[nodiscard]] const SweepCounts& counts() const { return counts_; }
    [[nodiscard]] const FailedImpacts& failed() const { return failed_; }

    template <class Archive>
    void transfer(Archive& archive) {
        archive(chunks_, sums_, counts_, failed_);
    }

  private:
    std::uint64_t chunks_ = 0;
    PairwiseMerge<SweepSums> sums_;
    SweepCounts counts_;
    FailedImpacts failed_;
};

}  // namespace ashimpact
