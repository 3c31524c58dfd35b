// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/series.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "tests/relative_difference.hpp"

using namespace ashimpact;
using ashimpact::test::relative_difference;

namespace {

/// Coefficients of 1/(1 - h/r), whose radius of convergence is r.
template <class Real>
Series<Real> geometric(Real factor, Real r) {
    Series<Real> c;
    for (std::size_t n = 0; n < c.size(); ++n) c[n] = factor * std::pow(r, -static_cast<Real>(n));
    return c;
}

template <class Real>
Series<Real> exponential() {
    Series<Real> c;
    c[0] = 1;
    for (std::size_t n = 1; n < c.size(); ++n) c[n] = c[n - 1] / static_cast<Real>(n);
    return c;
}

}  // namespace

TEST_CASE("a series is exact to rounding within radius/e^2 of its centre") {
    const double r = 4.7e-8;
    const double h = r / std::exp(2.0);
    CHECK(relative_difference(value(geometric(1.0, r), h), 1.0 / (1.0 - std::exp(-2.0))) < 1e-15);
    const long double extended = value(geometric(1.0L, 4.7e-8L), 4.7e-8L / std::exp(2.0L));
    CHECK(std::abs(extended - 1.0L / (1.0L - std::exp(-2.0L))) < 1e-18L);
    CHECK(relative_difference(value(exponential<double>(), 0.5), std::exp(0.5)) < 1e-15);
    CHECK(value(exponential<double>(), 0.0) == 1.0);
}

TEST_CASE("product coefficients are those of the product") {
    const auto a = exponential<double>();
    auto b = exponential<double>();
    for (std::size_t n = 1; n < b.size(); n += 2) b[n] = -b[n];  // exp(-h)
    CHECK(product_coefficient(a, b, 0) == 1.0);
    for (std::size_t n = 1; n < a.size(); ++n) CHECK(std::abs(product_coefficient(a, b, n)) < 1e-16);
    for (std::size_t n = 0; n < a.size(); ++n) {  // exp(2h)
        CHECK(relative_difference(product_coefficient(a, a, n), std::exp2(static_cast<double>(n)) * a[n]) <
              1e-14);
    }
}

TEST_CASE("the radius of a geometric series is its own, whatever its size") {
    for (const double r : {1e-9, 0.37, 5.0e3}) {
        for (const double factor : {1e-12, 1.0, 3e7}) {
            CHECK(relative_difference(radius(geometric(factor, r)), r) < 1e-13);
        }
    }
}

TEST_CASE("the radius sees past gaps in the series, and is infinite where nothing follows") {
    Series<double> gaps{};  // 1/(1 - (h/r)^9): eight zeros between the terms
    const double r = 0.02;
    for (std::size_t n = 0; n < gaps.size(); n += 9) gaps[n] = std::pow(r, -static_cast<double>(n));
    CHECK(relative_difference(radius(gaps), r) < 1e-13);
    Series<double> line{};
    line[0] = 2.0;
    line[1] = -1.0;
    CHECK(radius(line) == std::numeric_limits<double>::infinity());
}

TEST_CASE("a sign change is found to rounding, forward and backward") {
    int calls = 0;
    const auto cosine = [&](double h) {
        ++calls;
        return std::cos(h);
    };
    const double half_pi = std::acos(0.0);
    CHECK(relative_difference(sign_change<double>(cosine, 2.0), half_pi) < 1e-15);
    CHECK(relative_difference(sign_change<double>(cosine, -2.0), -half_pi) < 1e-15);
    CHECK(calls < 60);
}

TEST_CASE("a sign change of a steep, flat or tiny function stays in its bracket and converges") {
    const auto flat = [](double h) { return std::pow(h - 0.3, 9); };
    CHECK(std::abs(sign_change<double>(flat, 1.0) - 0.3) < 1e-3);
    const auto steep = [](double h) { return std::tanh(1e6 * (h - 0.7)); };
    CHECK(relative_difference(sign_change<double>(steep, 1.0), 0.7) < 1e-13);
    const auto tiny = [](double h) { return 1e-200 * (h - 2e-9); };
    CHECK(relative_difference(sign_change<double>(tiny, 5e-9), 2e-9) < 1e-14);
    const auto jump = [](double h) { return h < 0.123 ? -1.0 : 1.0; };
    CHECK(std::abs(sign_change<double>(jump, 1.0) - 0.123) < 1e-15);
}

TEST_CASE("a search that starts on the event finds the next one") {
    const auto arc = [](double h) { return h * (0.25 - h); };
    CHECK(relative_difference(sign_change<double>(arc, 1.0), 0.25) < 1e-14);
}
