#pragma once

#include "pipeline/sweep/crew/chunk.hpp"

namespace ashimpact {

/// All chunks up to some number, merged. Its size does not depend on how many they are.
class Tally {
  public:
    /// Adds the block that begins where the tally ends.
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
