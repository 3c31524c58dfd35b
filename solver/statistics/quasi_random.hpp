// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ashimpact {

enum class QuasiRandomSequence {
    sobol,        ///< direction numbers of Joe & Kuo 2008
    niederreiter  ///< base 2; Bratley, Fox & Niederreiter 1994
};

/// A digital sequence in base 2: points of the unit cube that fill it more evenly than random ones. Point n
/// is the exclusive or of the direction numbers at the bits of the Gray code of n (Antonov & Saleev 1979), so
/// any part of a sequence can be made by itself. Point 0 is the origin. The direction numbers are those of
/// Boost.Random; see docs/decisions/0009-quasi-random.md.
class DigitalSequence {
  public:
    /// @throws InputError for a dimension the tables do not reach
    DigitalSequence(QuasiRandomSequence sequence, std::size_t dimension);

    [[nodiscard]] std::size_t dimension() const { return directions_.size(); }

    /// Coordinate @p axis of the points first, first + 1, ..., as binary fractions of 64 digits.
    void fill(std::size_t axis, std::uint64_t first, std::span<std::uint64_t> points) const;

    /// The greatest dimension of a sequence.
    [[nodiscard]] static std::size_t greatest_dimension(QuasiRandomSequence sequence);

  private:
    static constexpr std::size_t bits = 63;  ///< points beyond 2^63 are not needed

    std::vector<std::vector<std::uint64_t>> directions_;  ///< of each axis
};

}  // namespace ashimpact
