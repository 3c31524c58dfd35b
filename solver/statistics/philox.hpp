// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace ashimpact {

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
