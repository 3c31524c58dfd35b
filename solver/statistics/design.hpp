// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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

/// Philox4x32-10, a counter-based random generator: the same key and counter give the same 128 bits anywhere,
/// so a sample can be drawn by its number alone. Salmon, Moraes, Dror & Shaw 2011, SC'11,
/// doi 10.1145/2063384.2063405; passes TestU01's BigCrush.
[[nodiscard]] constexpr std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                            std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t even = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t odd = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {
            static_cast<std::uint32_t>(odd >> 32U) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(odd),
            static_cast<std::uint32_t>(even >> 32U) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(even)};
        key[0] += 0x9E3779B9;
        key[1] += 0xBB67AE85;
    }
    return counter;
}

/// What a random stream is for; streams of one seed do not overlap.
enum class RandomStream : std::uint32_t { points = 0, shifts = 1 };

/// Two words of 64 random bits: those of samples 2 @p pair and 2 @p pair + 1 on one axis.
[[nodiscard]] constexpr std::array<std::uint64_t, 2> random_bits(std::uint64_t seed, std::uint64_t pair,
                                                                 std::uint32_t axis, RandomStream stream) {
    const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
    const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32U); };
    const auto bits =
        philox({low(pair), high(pair), axis, static_cast<std::uint32_t>(stream)}, {low(seed), high(seed)});
    return {bits[0] | std::uint64_t{bits[1]} << 32U, bits[2] | std::uint64_t{bits[3]} << 32U};
}

/// A number of the open interval (0, 1) from 64 bits: the middle of one of 2^52 equal cells.
[[nodiscard]] constexpr double unit_interval(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52;
}

/// Numbers of the interval (0, 1) for consecutive samples of one axis, several in each instruction: those
/// that unit_interval() makes of random_bits(), bit for bit.
/// @param first number of the first sample
void fill_uniform(std::uint64_t seed, std::uint64_t first, std::uint32_t axis, RandomStream stream,
                  std::span<double> values);

}  // namespace ashimpact
