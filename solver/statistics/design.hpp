// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solver/statistics/distribution.hpp"

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

enum class SamplingMethod { grid, random, quasi_random };

/// How the points of a design are chosen.
struct Sampling {
    SamplingMethod method;
    std::uint64_t points = 0;  ///< of a grid: its own number
    std::uint64_t seed = 0;
    QuasiRandomSequence sequence = QuasiRandomSequence::sobol;
    std::uint32_t shifts = 16;  ///< independently shifted copies of a quasi-random sequence
};

/// The points at which variables are evaluated. Each point follows from its number alone.
///
/// A grid is the full product of the variables' values, the last variable running fastest. Random points come
/// from a counter-based generator, the point's number being the counter. Quasi-random points are those of a
/// digital sequence, taken in turn by copies of it whose digits are shifted at random (exclusive or), so that
/// the spread of the copies estimates the error.
class Design {
  public:
    /// @param samples independent values of each variable in one point: 1, or 2 for sensitivity indices
    /// @throws InputError for a grid of a distribution, or more dimensions than the sequence has
    Design(std::vector<Distribution> variables, const Sampling& sampling, std::size_t samples = 1);

    [[nodiscard]] std::uint64_t points() const { return sampling_.points; }
    [[nodiscard]] std::size_t variables() const { return variables_.size(); }
    [[nodiscard]] std::size_t samples() const { return samples_; }

    /// Number of groups by whose spread errors are estimated: points n with equal n % groups() form a group.
    [[nodiscard]] std::uint32_t groups() const { return groups_; }

    /// Values of a variable in the points first, first + 1, ... [SI].
    void fill(std::size_t sample, std::size_t variable, std::uint64_t first, std::span<double> values) const;

  private:
    void fill_grid(std::size_t variable, std::uint64_t first, std::span<double> values) const;
    void fill_quasi_random(std::size_t axis, std::uint64_t first, std::span<double> values) const;

    std::vector<Distribution> variables_;
    Sampling sampling_;
    std::size_t samples_;
    std::uint32_t groups_ = 1;
    std::optional<DigitalSequence> sequence_;
    std::vector<std::vector<std::uint64_t>> shifts_;  ///< of each axis, one a copy
};

}  // namespace ashimpact
