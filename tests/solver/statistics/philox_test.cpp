// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/philox.hpp"

#include <vector>

#include <doctest/doctest.h>

using namespace ashimpact;

namespace {

using Words = std::array<std::uint32_t, 4>;

}  // namespace

TEST_CASE("Philox gives the known answers of Random123 1.14, tests/kat_vectors") {
    CHECK(philox({0, 0, 0, 0}, {0, 0}) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
    CHECK(philox({~0U, ~0U, ~0U, ~0U}, {~0U, ~0U}) == Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
    CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("numbers of the unit interval never reach its ends") {
    CHECK(unit_interval(0) == 0x1p-53);
    CHECK(unit_interval(~std::uint64_t{0}) == 1 - 0x1p-53);
}

TEST_CASE("seed, sample, axis and stream each change the bits") {
    const auto bits = random_bits(1, 2, 3, RandomStream::points);
    CHECK(bits[0] != bits[1]);
    CHECK(bits != random_bits(2, 2, 3, RandomStream::points));
    CHECK(bits != random_bits(1, 3, 3, RandomStream::points));
    CHECK(bits != random_bits(1, 2, 4, RandomStream::points));
    CHECK(bits != random_bits(1, 2, 3, RandomStream::shifts));
    CHECK(bits != random_bits(1, 2 + (std::uint64_t{1} << 32U), 3, RandomStream::points));
}

TEST_CASE("many random numbers at once are those drawn one by one, bit for bit") {
    constexpr std::uint64_t seed = 0xfedcba9876543210;
    for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{7}, (std::uint64_t{1} << 33U) - 9}) {
        for (const std::size_t count : {0U, 1U, 2U, 3U, 16U, 17U, 31U, 64U, 101U}) {
            std::vector<double> values(count);
            fill_uniform(seed, first, 3, RandomStream::points, values);
            for (std::size_t i = 0; i < count; ++i) {
                const std::uint64_t sample = first + i;
                const auto bits = random_bits(seed, sample / 2, 3, RandomStream::points);
                CHECK(values[i] == unit_interval(bits[sample % 2]));
            }
        }
    }
}
