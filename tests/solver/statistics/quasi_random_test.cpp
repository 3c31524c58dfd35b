// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/statistics/design.hpp"

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

}  // namespace

TEST_CASE("the first points of Sobol's sequence are the known ones") {
    const DigitalSequence sobol(QuasiRandomSequence::sobol, 2);
    constexpr std::uint64_t quarter = std::uint64_t{1} << 62U;
    CHECK(coordinates(sobol, 0, 0, 4) == std::vector<std::uint64_t>{0, 2 * quarter, 3 * quarter, quarter});
    CHECK(coordinates(sobol, 1, 0, 4) == std::vector<std::uint64_t>{0, 2 * quarter, quarter, 3 * quarter});
}

namespace {

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

}  // namespace

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
