// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/spec/spec.hpp"

namespace ashimpact {

/// A column of the full table.
struct TableColumn {
    std::string path;  ///< in the file, "variables/velocity", "dmt/restitution"
    std::string unit;
    std::string description;
};

/// A spec with its division into work. Points come in chunks of a fixed number. Each point gives one impact;
/// for sensitivity indices it gives one at a, one at b and one at a for each variable taken from b. Each
/// impact is solved with every law.
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
    /// Impacts of one point that are a sample of the variables, as statistics need them: all but the mixed
    /// ones.
    [[nodiscard]] std::size_t samples_a_point() const { return design_.samples(); }
    [[nodiscard]] std::uint64_t chunks() const {
        return (design_.points() + chunk_points_ - 1) / chunk_points_;
    }
    /// Points of a chunk; the last one has what is left.
    [[nodiscard]] std::size_t points_in(std::uint64_t chunk) const;
    [[nodiscard]] std::uint64_t first_point(std::uint64_t chunk) const { return chunk * chunk_points_; }
    /// Rows of the full table in a whole chunk.
    [[nodiscard]] std::size_t rows_in_chunk() const { return points_in(0) * impacts_a_point(); }
    [[nodiscard]] std::uint64_t rows() const { return design_.points() * impacts_a_point(); }
    /// Solved impacts of the whole sweep.
    [[nodiscard]] std::uint64_t impacts() const { return rows() * spec().laws.size(); }

    [[nodiscard]] WantedResults wanted() const;
    /// Columns of the full table; none where no table is wanted.
    [[nodiscard]] std::vector<TableColumn> table_columns() const;

  private:
    LoadedSpec loaded_;
    std::string hash_;
    Design design_;
    std::size_t chunk_points_;
};

}  // namespace ashimpact
