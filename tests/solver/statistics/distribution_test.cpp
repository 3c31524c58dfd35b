// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "solver/numeric/gsl/statistics.hpp"

using namespace ashimpact;

namespace {

double quantile(const Distribution& distribution, double probability) {
    std::array<double, 1> value{probability};
    to_quantiles(distribution, value);
    return value[0];
}

double normal_below(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

const auto relative = [](double value) { return doctest::Approx(value).epsilon(1e-12); };

}  // namespace

TEST_CASE("quantiles are the inverse of what is below them, at fly-ash scale") {
    for (const double p : {1e-6, 0.02, 0.3, 0.5, 0.77, 0.999}) {
        CAPTURE(p);
        const double uniform = quantile(Uniform{22e-6, 44e-6}, p);
        CHECK((uniform - 22e-6) / 22e-6 == relative(p));
        const double logarithmic = quantile(LogUniform{1e-6, 1e-4}, p);
        CHECK(std::log(logarithmic / 1e-6) / std::log(100) == relative(p));
        CHECK(normal_below((quantile(Normal{90e9, 5e9}, p) - 90e9) / 5e9) == relative(p));
        const double size = quantile(LogNormal{44e-6, 1.5}, p);
        CHECK(normal_below(std::log(size / 44e-6) / std::log(1.5)) == relative(p));
        const Triangular triangular{0.1, 0.25, 0.4};
        const double x = quantile(triangular, p);
        const double below =
            x < 0.25 ? (x - 0.1) * (x - 0.1) / (0.3 * 0.15) : 1 - (0.4 - x) * (0.4 - x) / (0.3 * 0.15);
        CHECK(below == doctest::Approx(p).epsilon(1e-9));
    }
}

TEST_CASE("normal quantiles in lanes are those of GSL, over the whole range and one by one") {
    std::vector<double> probabilities;
    probabilities.reserve(2354 + 1429 + 32);
    for (int i = 0; i < 2354; ++i) probabilities.push_back(std::exp2(-1070 + std::log2(1.37) * i));
    for (int i = 0; i < 1429; ++i) probabilities.push_back(0.0003 + 0.0007 * i);
    for (int i = 0; i < 32; ++i) probabilities.push_back(1.0 - 0x1p-53 * std::pow(3.0, i));
    std::vector<double> together = probabilities;
    to_quantiles(Normal{0.0, 1.0}, together);
    std::vector<double> sizes = probabilities;
    to_quantiles(LogNormal{44e-6, 1.5}, sizes);
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
        const double p = probabilities[i];
        CAPTURE(p);
        const double expected = gsl::normal_quantile(p);
        CHECK(std::abs(together[i] - expected) <= 4e-15 * std::max(std::abs(expected), 0x1p-10));
        CHECK(quantile(Normal{0.0, 1.0}, p) == together[i]);
        CHECK(sizes[i] == doctest::Approx(44e-6 * std::pow(1.5, expected)).epsilon(2e-14));
        CHECK(quantile(LogNormal{44e-6, 1.5}, p) == sizes[i]);
    }
}

TEST_CASE("log-normal quantiles of a spread that fills the range of numbers") {
    for (const double spread : {1e-3, 3.0, 40.0}) {
        for (int i = 0; i < 1370; ++i) {
            const double p = 0x1p-53 + 0.00073 * i;
            CAPTURE(spread);
            CAPTURE(p);
            const double exponent = std::log(std::exp(spread)) * quantile(Normal{0.0, 1.0}, p);
            const double expected = std::exp(exponent);
            const double rounding = 4e-16 * (1.0 + std::abs(exponent));
            CHECK(std::abs(quantile(LogNormal{1.0, std::exp(spread)}, p) / expected - 1.0) <= rounding);
        }
    }
}

TEST_CASE("a cut normal distribution keeps its shape between the cuts") {
    const Normal cut{2.0, 1.0, 1.5, 4.0};
    for (const double p : {0.001, 0.4, 0.9}) {
        const double value = quantile(cut, p);
        CHECK(value >= 1.5);
        CHECK(value <= 4.0);
        const double below =
            (normal_below(value - 2) - normal_below(-0.5)) / (normal_below(2) - normal_below(-0.5));
        CHECK(below == relative(p));
    }
    CHECK(quantile(Normal{0, 1, -3, 3}, 0.5) == doctest::Approx(0).epsilon(1e-15));
}

TEST_CASE("a cut far out in either tail keeps its digits") {
    // Beyond 10 standard deviations the tail falls like exp(-10 x), so half of it is below ln(2)/10.1 or so.
    const double upper = quantile(Normal{0, 1, 10, 50}, 0.5);
    const double lower = quantile(Normal{0, 1, -50, -10}, 0.5);
    CHECK(upper == relative(-lower));
    CHECK(std::erfc(upper / std::numbers::sqrt2) / std::erfc(10 / std::numbers::sqrt2) ==
          doctest::Approx(0.5).epsilon(1e-9));
}

TEST_CASE("a choice gives each value with the same probability") {
    const Choice choice{{3, 1, 2}};
    CHECK(quantile(choice, 1e-9) == 3);
    CHECK(quantile(choice, 0.34) == 1);
    CHECK(quantile(choice, 1 - 0x1p-53) == 2);
}

TEST_CASE("the support holds every value") {
    CHECK(support_of(Choice{{3, 1, 2}}).lowest == 1);
    CHECK(support_of(Choice{{3, 1, 2}}).highest == 3);
    CHECK(support_of(Normal{1, 2}).lowest == -INFINITY);
    CHECK(support_of(LogNormal{44e-6, 1.5}).lowest == 0);
    CHECK(support_of(Triangular{1, 2, 3}).highest == 3);
    const LogUniform logarithmic{0.1, 3};
    CHECK(quantile(logarithmic, 0x1p-53) >= 0.1);
    CHECK(quantile(logarithmic, 1 - 0x1p-53) <= 3);
}

TEST_CASE("grids meet both ends exactly") {
    CHECK(linear_grid(0.1, 0.7, 4).front() == 0.1);
    CHECK(linear_grid(0.1, 0.7, 4)[1] == relative(0.3));
    CHECK(linear_grid(0.1, 0.7, 4).back() == 0.7);
    CHECK(logarithmic_grid(1e-6, 1e-3, 4)[1] == relative(1e-5));
    CHECK(logarithmic_grid(1e-6, 1e-3, 4).back() == 1e-3);
    CHECK(linear_grid(5, 9, 1) == std::vector<double>{5});
}
