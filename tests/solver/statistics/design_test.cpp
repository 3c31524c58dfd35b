// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/design.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "core/text/error.hpp"

using namespace ashimpact;

namespace {

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
