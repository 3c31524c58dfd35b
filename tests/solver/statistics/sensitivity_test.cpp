// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "solver/statistics/design.hpp"
#include "solver/statistics/propagation.hpp"

using namespace ashimpact;

namespace {

using std::numbers::pi;

/// Ishigami & Homma 1990: sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1 on [-pi, pi]^3, moved far from zero.
double ishigami(const std::array<double, 3>& x) {
    return 100 + std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

struct Known {
    std::array<double, 3> first;
    std::array<double, 3> total;
};

/// From its variance by parts (Saltelli et al. 2008, Global Sensitivity Analysis, p. 179).
Known known_indices() {
    const double b = 0.1;
    const double v1 = 0.5 * std::pow(1 + b * std::pow(pi, 4) / 5, 2);
    const double v2 = 7.0 * 7.0 / 8;
    const double v13 = b * b * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50);
    const double v = v1 + v2 + v13;
    return {{v1 / v, v2 / v, 0}, {(v1 + v13) / v, v2 / v, v13 / v}};
}

/// Sums of each group of a design, made chunk by chunk.
std::vector<SobolSums> sums_of(const Design& design, std::size_t chunk) {
    std::vector<SobolSums> groups(design.groups());
    for (std::uint64_t first = 0; first < design.points(); first += chunk) {
        std::array<std::array<std::vector<double>, 3>, 2> x;
        for (const std::size_t sample : {0, 1}) {
            for (const std::size_t variable : {0, 1, 2}) {
                x[sample][variable].resize(chunk);
                design.fill(sample, variable, first, x[sample][variable]);
            }
        }
        for (std::uint32_t group = 0; group < design.groups(); ++group) {
            std::array<std::vector<double>, 5> f;
            for (std::size_t i = group; i < chunk; i += design.groups()) {
                const std::array a{x[0][0][i], x[0][1][i], x[0][2][i]};
                const std::array b{x[1][0][i], x[1][1][i], x[1][2][i]};
                f[0].push_back(ishigami(a));
                f[1].push_back(ishigami(b));
                f[2].push_back(ishigami({b[0], a[1], a[2]}));
                f[3].push_back(ishigami({a[0], b[1], a[2]}));
                f[4].push_back(ishigami({a[0], a[1], b[2]}));
            }
            groups[group].merge(SobolSums::of({f[0], f[1], {f[2], f[3], f[4]}}));
        }
    }
    return groups;
}

Design design_of(const Sampling& sampling) {
    const Uniform angle{-pi, pi};
    return Design({angle, angle, angle}, sampling, 2);
}

}  // namespace

TEST_CASE("the indices of the Ishigami function, with their errors") {
    struct Expected {
        Sampling sampling;
        double deviation;    ///< greatest difference from the known indices
        double least_error;  ///< allowed beside the estimated errors
    };
    const Known known = known_indices();
    for (const Expected& expected :
         {Expected{{.method = SamplingMethod::quasi_random, .points = 1 << 16, .seed = 1}, 0.004, 1e-6},
          Expected{{.method = SamplingMethod::random, .points = 1 << 15, .seed = 5}, 0.15, 0.0}}) {
        const auto indices = sobol_indices(sums_of(design_of(expected.sampling), 1 << 13));
        REQUIRE(indices.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            CAPTURE(i);
            const double first = std::abs(indices[i].first - known.first[i]);
            const double total = std::abs(indices[i].total - known.total[i]);
            CHECK(*indices[i].first_error < 0.03);
            CHECK(std::max(first, total) < expected.deviation);
            CHECK(first < 5 * *indices[i].first_error + expected.least_error);
            CHECK(total < 5 * *indices[i].total_error + expected.least_error);
        }
    }
}

TEST_CASE("chunks do not change the indices beyond rounding") {
    const Design design = design_of({.method = SamplingMethod::random, .points = 1 << 12, .seed = 5});
    const auto whole = sobol_indices(sums_of(design, 1 << 12));
    const auto parts = sobol_indices(sums_of(design, 1 << 7));
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(parts[i].first == doctest::Approx(whole[i].first).epsilon(1e-12));
        CHECK(parts[i].total == doctest::Approx(whole[i].total).epsilon(1e-12));
    }
}

TEST_CASE("a function that does not vary has no indices; one group gives no errors") {
    const std::vector<double> same(10, 3.0);
    const std::array constant{SobolSums::of({same, same, {same}})};
    CHECK(sobol_indices(constant).empty());

    const std::vector<double> a{1, 2, 3, 5};
    const std::vector<double> b{2, 7, 1, 8};
    const std::array one{SobolSums::of({a, b, {b}})};
    const auto indices = sobol_indices(one);
    REQUIRE(indices.size() == 1);
    CHECK_FALSE(indices[0].first_error.has_value());
}
