// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/design.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"

using namespace ashimpact;

namespace {

constexpr auto both = {QuasiRandomSequence::sobol, QuasiRandomSequence::niederreiter};

std::vector<std::uint64_t> coordinates(const DigitalSequence& sequence, std::size_t axis, std::uint64_t first,
                                       std::size_t count) {
    std::vector<std::uint64_t> points(count);
    sequence.fill(axis, first, points);
    return points;
}

/// How many cells of the grid 2^rows x 2^columns a block of 2^(rows + columns) points meets.
std::size_t cells_met(const DigitalSequence& sequence, unsigned rows, unsigned columns, std::uint64_t block) {
    const std::size_t count = std::size_t{1} << (rows + columns);
    const auto x = coordinates(sequence, 0, block * count, count);
    const auto y = coordinates(sequence, 1, block * count, count);
    std::set<std::pair<std::uint64_t, std::uint64_t>> cells;
    for (std::size_t i = 0; i < count; ++i)
        cells.emplace(rows == 0 ? 0 : x[i] >> (64 - rows), columns == 0 ? 0 : y[i] >> (64 - columns));
    return cells.size();
}

/// The fewest of 1024 equal intervals that a block of 1024 points meets on an axis.
std::size_t fewest_intervals_met(const DigitalSequence& sequence, std::size_t axis) {
    std::size_t fewest = 1024;
    for (const std::uint64_t block : {0, 1, 7, 1000}) {
        std::set<std::uint64_t> intervals;
        for (const std::uint64_t point : coordinates(sequence, axis, block * 1024, 1024))
            intervals.insert(point >> 54U);
        fewest = std::min(fewest, intervals.size());
    }
    return fewest;
}

using Words = std::array<std::uint32_t, 4>;

std::vector<double> values(const Design& design, std::size_t sample, std::size_t variable,
                           std::uint64_t first, std::size_t count) {
    std::vector<double> values(count);
    design.fill(sample, variable, first, values);
    return values;
}

const std::vector<Distribution> two_uniform{Uniform{0, 1}, Uniform{0, 1}};

Sampling random_points(std::uint64_t points) {
    return {.method = SamplingMethod::random, .points = points, .seed = 42};
}

Sampling quasi_random_points(std::uint64_t points, std::uint32_t shifts) {
    return {.method = SamplingMethod::quasi_random, .points = points, .seed = 42, .shifts = shifts};
}

/// Error of the mean of x y over the unit square, which is 1/4.
double error_of_product(const Design& design) {
    const auto x = values(design, 0, 0, 0, design.points());
    const auto y = values(design, 0, 1, 0, design.points());
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
    return std::abs(sum / static_cast<double>(x.size()) - 0.25);
}

}  // namespace

TEST_CASE("the first points of Sobol's sequence are the known ones") {
    const DigitalSequence sobol(QuasiRandomSequence::sobol, 2);
    constexpr std::uint64_t quarter = std::uint64_t{1} << 62U;
    CHECK(coordinates(sobol, 0, 0, 4) == std::vector<std::uint64_t>{0, 2 * quarter, 3 * quarter, quarter});
    CHECK(coordinates(sobol, 1, 0, 4) == std::vector<std::uint64_t>{0, 2 * quarter, quarter, 3 * quarter});
}

TEST_CASE(
    "every block of 2^m points of Sobol's sequence has one in each of 2^m equal intervals, on every axis") {
    const DigitalSequence sobol(QuasiRandomSequence::sobol, 40);
    for (std::size_t axis = 0; axis < 40; ++axis) CHECK(fewest_intervals_met(sobol, axis) == 1024);
}

TEST_CASE("Niederreiter's sequence does so on the axes whose polynomial's degree divides m") {
    const DigitalSequence niederreiter(QuasiRandomSequence::niederreiter, 4);
    for (const std::size_t axis : {0, 1, 2})
        CHECK(fewest_intervals_met(niederreiter, axis) == 1024);  // degrees 1, 1, 2
    CHECK(fewest_intervals_met(niederreiter, 3) >= 256);          // degree 3
}

TEST_CASE("two axes of Sobol's sequence make (0, m, 2)-nets") {
    const DigitalSequence sobol(QuasiRandomSequence::sobol, 2);
    for (unsigned rows = 0; rows <= 10; ++rows)
        for (const std::uint64_t block : {0, 1, 5}) CHECK(cells_met(sobol, rows, 10 - rows, block) == 1024);
}

TEST_CASE("a part of a sequence is the same wherever it begins") {
    for (const auto kind : both) {
        const DigitalSequence sequence(kind, 3);
        const auto whole = coordinates(sequence, 2, 0, 3000);
        for (const std::size_t first : {1, 2, 3, 1023, 1024, 2047})
            CHECK(coordinates(sequence, 2, first, 900) ==
                  std::vector<std::uint64_t>(whole.begin() + static_cast<std::ptrdiff_t>(first),
                                             whole.begin() + static_cast<std::ptrdiff_t>(first + 900)));
    }
}

TEST_CASE("points far out are there at once") {
    const DigitalSequence sobol(QuasiRandomSequence::sobol, 1);
    const std::uint64_t far = std::uint64_t{1} << 60U;
    CHECK(coordinates(sobol, 0, far, 2)[0] != coordinates(sobol, 0, far, 2)[1]);
}

TEST_CASE("a dimension beyond the tables is refused") {
    CHECK_NOTHROW(DigitalSequence(QuasiRandomSequence::niederreiter, 40));
    CHECK_THROWS_AS(DigitalSequence(QuasiRandomSequence::sobol, 3668), InputError);
    CHECK_THROWS_AS(DigitalSequence(QuasiRandomSequence::sobol, 0), InputError);
}

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

TEST_CASE("a grid is the full product, the last variable running fastest") {
    const Design grid({Choice{{1, 2}}, Choice{{10, 20, 30}}}, {.method = SamplingMethod::grid});
    CHECK(grid.points() == 6);
    CHECK(grid.groups() == 1);
    CHECK(values(grid, 0, 0, 0, 6) == std::vector<double>{1, 1, 1, 2, 2, 2});
    CHECK(values(grid, 0, 1, 0, 6) == std::vector<double>{10, 20, 30, 10, 20, 30});
    CHECK(values(grid, 0, 1, 4, 2) == std::vector<double>{20, 30});
}

TEST_CASE("a grid of a distribution, or of more points than a number holds, is refused") {
    CHECK_THROWS_AS(Design({Uniform{0, 1}}, {.method = SamplingMethod::grid}), InputError);
    const Choice many{std::vector<double>(1'000'000, 1.0)};
    CHECK_THROWS_AS(Design({many, many, many, many}, {.method = SamplingMethod::grid}), InputError);
}

TEST_CASE("any part of a design is the same as in the whole") {
    for (const Sampling& sampling : {random_points(1000), quasi_random_points(1000, 1),
                                     quasi_random_points(1000, 7), quasi_random_points(1000, 16)}) {
        const Design design(two_uniform, sampling, 2);
        for (const std::size_t sample : {0, 1}) {
            for (const std::size_t variable : {0, 1}) {
                const auto whole = values(design, sample, variable, 0, 1000);
                std::vector<double> parts;
                for (std::size_t first = 0; first < 1000;) {
                    const std::size_t count = std::min<std::size_t>(1 + first % 13, 1000 - first);
                    const auto part = values(design, sample, variable, first, count);
                    parts.insert(parts.end(), part.begin(), part.end());
                    first += count;
                }
                CHECK(parts == whole);
            }
        }
    }
}

TEST_CASE("variables, samples and seeds are independent") {
    const Design design(two_uniform, random_points(100), 2);
    CHECK(values(design, 0, 0, 0, 100) != values(design, 0, 1, 0, 100));
    CHECK(values(design, 0, 0, 0, 100) != values(design, 1, 0, 0, 100));
    auto other = random_points(100);
    other.seed = 43;
    CHECK(values(Design(two_uniform, other), 0, 0, 0, 100) != values(design, 0, 0, 0, 100));
}

TEST_CASE("quasi-random points integrate far better than random ones") {
    const double random = error_of_product(Design(two_uniform, random_points(1 << 14)));
    const double even = error_of_product(Design(two_uniform, quasi_random_points(1 << 14, 1)));
    const double shifted = error_of_product(Design(two_uniform, quasi_random_points(1 << 14, 16)));
    CHECK(random < 0.01);
    CHECK(even < 1e-4);
    CHECK(shifted < 1e-4);
}
