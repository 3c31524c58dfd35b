// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/importance_sampling.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/relative_difference.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

using Plane = ImportanceSampling<2>;

Plane::NormalDensity wide_normal(double x, double y) {
    return {.mean = {x, y}, .covariance = 4.0 * Plane::Matrix::Identity()};
}

/// Draws in rounds, each from the moments of those before.
Plane adapted(const std::function<double(const Plane::Vector&)>& density, const Plane::NormalDensity& start) {
    Plane draws(density);
    draws.add(start, 500);
    for (int i = 0; i < 12; ++i) draws.add(draws.moments(), 800);
    return draws;
}

}  // namespace

TEST_CASE("importance sampling of a normal density gives its quantiles") {
    // Means 3 and -1, standard deviations 0.2 and 0.5, correlation 0.8.
    Plane::Matrix covariance;
    covariance << 0.04, 0.08, 0.08, 0.25;
    const Plane::Matrix inverse = covariance.inverse();
    const Plane::Vector mean(3.0, -1.0);
    const auto draws =
        adapted([&](const Plane::Vector& p) { return 0.5 * (p - mean).dot(inverse * (p - mean)); },
                wide_normal(2.0, 0.0));
    CHECK(draws.effective() > 3000.0);
    const MarginalSample x = draws.marginal(0);
    const MarginalSample y = draws.marginal(1);
    CHECK(std::abs(x.quantile(0.5) - 3.0) < 0.01);
    CHECK(std::abs(x.quantile(0.975) - 3.39199) < 0.02);
    CHECK(std::abs(y.quantile(0.025) + 1.97998) < 0.05);
    CHECK(relative_difference(x.standard_deviation(), 0.2) < 0.02);
    CHECK(relative_difference(y.standard_deviation(), 0.5) < 0.02);
    CHECK((draws.likeliest() - mean).norm() < 0.05);
}

TEST_CASE("importance sampling of a skewed, curved density gives the quantiles of its marginal") {
    // exp(x) is exponentially distributed, y is normal around x^2: the quantiles of x are ln(-ln(1 - p)).
    const auto density = [](const Plane::Vector& p) {
        const double from_curve = p[1] - p[0] * p[0];
        return std::exp(p[0]) - p[0] + 0.5 * from_curve * from_curve;
    };
    const auto draws = adapted(density, wide_normal(0.0, 0.0));
    REQUIRE(draws.effective() > 400.0);
    const MarginalSample x = draws.marginal(0);
    for (const double p : {0.1, 0.5, 0.9, 0.975}) {
        CAPTURE(p);
        CHECK(std::abs(x.quantile(p) - std::log(-std::log1p(-p))) < 0.15);
    }
}

TEST_CASE("importance sampling finds both of two modes that were given") {
    const auto density = [](const Plane::Vector& p) {
        const double first = std::exp(-0.5 * (p - Plane::Vector(-3.0, 0.0)).squaredNorm());
        const double second = 3.0 * std::exp(-0.5 * (p - Plane::Vector(3.0, 0.0)).squaredNorm());
        return -std::log(std::max(first + second, 1e-300));
    };
    Plane draws(density);
    draws.add(wide_normal(-3.0, 0.0), 500);
    draws.add(wide_normal(3.0, 0.0), 500);
    for (int i = 0; i < 6; ++i) draws.add(draws.moments(), 800);
    // A quarter of the weight lies around -3.
    CHECK(std::abs(draws.marginal(0).quantile(0.125) + 3.0) < 0.15);
    CHECK(std::abs(draws.marginal(0).quantile(0.625) - 3.0) < 0.15);
}

TEST_CASE("quantiles of weighted values lie on lines between the middles of their weights") {
    const MarginalSample sample({{3.0, 0.25}, {0.0, 0.25}, {1.0, 0.5}});
    // Middles of the weights: 0.125, 0.5 and 0.875.
    CHECK(sample.quantile(0.01) == 0.0);
    CHECK(sample.quantile(0.125) == 0.0);
    CHECK(sample.quantile(0.3125) == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(sample.quantile(0.5) == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(sample.quantile(0.6875) == doctest::Approx(2.0).epsilon(1e-15));
    CHECK(sample.quantile(0.99) == 3.0);
    CHECK(sample.mean() == doctest::Approx(1.25).epsilon(1e-15));
    CHECK(sample.standard_deviation() == doctest::Approx(std::sqrt(1.1875)).epsilon(1e-15));
}
