// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/spec/spec.hpp"
#include "solver/statistics/histogram.hpp"
#include "solver/statistics/moments.hpp"
#include "solver/statistics/propagation.hpp"

namespace ashimpact {

/// A column of the full table.
struct TableColumn {
    std::string path;  ///< in the file, "variables/velocity", "dmt/restitution"
    std::string unit;
    std::string description;
};

/// A spec and its division into chunks of a fixed number of points. A point is one impact. For sensitivity
/// indices a point is a pair of samples a and b of the variables, and its impacts are a, b, and for each
/// variable a with that variable from b. Each impact is solved with every law.
class SweepPlan {
  public:
    /// @throws InputError
    explicit SweepPlan(const std::string& spec_text);

    [[nodiscard]] const SweepSpec& spec() const { return loaded_.spec; }
    [[nodiscard]] const Design& design() const { return design_; }
    /// The spec without comments and layout.
    [[nodiscard]] const std::string& canonical() const { return loaded_.canonical; }
    /// SHA-256 of the spec without comments and layout.
    [[nodiscard]] const std::string& hash() const { return hash_; }

    [[nodiscard]] bool with_sensitivity() const { return !spec().sensitivity.empty(); }
    /// Impacts of one point and one law.
    [[nodiscard]] std::size_t impacts_a_point() const;
    /// Impacts of one point that count for statistics: a, or a and b, not the mixed ones.
    [[nodiscard]] std::size_t samples_a_point() const { return design_.samples(); }
    [[nodiscard]] std::uint64_t chunks() const {
        return (design_.points() + chunk_points_ - 1) / chunk_points_;
    }
    /// Points of a chunk; the last chunk has the remaining ones.
    [[nodiscard]] std::size_t points_in(std::uint64_t chunk) const;
    [[nodiscard]] std::uint64_t first_point(std::uint64_t chunk) const { return chunk * chunk_points_; }
    /// Rows of the full table in a whole chunk.
    [[nodiscard]] std::size_t rows_in_chunk() const { return points_in(0) * impacts_a_point(); }
    [[nodiscard]] std::uint64_t rows() const { return design_.points() * impacts_a_point(); }
    /// Solved impacts of the whole sweep.
    [[nodiscard]] std::uint64_t impacts() const { return rows() * spec().laws.size(); }

    /// What the impacts of a law are solved for, and how.
    [[nodiscard]] WantedResults wanted(Law law) const;
    /// Columns of the full table; empty if the spec has no table.
    [[nodiscard]] std::vector<TableColumn> table_columns() const;

  private:
    LoadedSpec loaded_;
    std::string hash_;
    Design design_;
    std::size_t chunk_points_;
};

/// 2^level consecutive chunks, the first a multiple of 2^level: a node of the merge tree, a unit of work.
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

    /// Adds the next block, which begins at chunk `chunks`. Its rows are left to the caller.
    void add(const Block& block, BlockResult result);
    void transfer(auto& archive) { archive(chunks, sums, counts, failed, row_bytes); }
};

}  // namespace ashimpact
