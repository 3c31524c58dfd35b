// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "solver/numeric/chebyshev.hpp"
#include "solver/numeric/interpolation.hpp"
#include "solver/numeric/least_median.hpp"
#include "solver/numeric/number.hpp"
#include "solver/numeric/polynomial.hpp"
#include "solver/numeric/series.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

TEST_CASE("a cubic is its own Chebyshev series, and so is its slope, within the interval and beyond") {
    const ChebyshevAxis axis{.lower = -1.0, .upper = 3.0, .degree = 5};
    const auto cubic = [](double x) { return ((0.5 * x - 2.0) * x + 1.0) * x + 4.0; };
    Eigen::VectorXd at_nodes(axis.degree + 1);
    for (int i = 0; i <= axis.degree; ++i) at_nodes[i] = cubic(axis.node(i));
    CHECK(axis.node(0) == axis.lower);
    CHECK(axis.node(axis.degree) == axis.upper);
    const Eigen::VectorXd coefficients = axis.analysis() * at_nodes;
    for (const double x : {-1.5, -1.0, -0.3, 1.0, 2.9, 3.5}) {
        CAPTURE(x);
        const ChebyshevBasis basis(axis, x);
        CHECK(coefficients.dot(basis.value) == doctest::Approx(cubic(x)).epsilon(1e-13));
        CHECK(coefficients.dot(basis.slope) == doctest::Approx((1.5 * x - 4.0) * x + 1.0).epsilon(1e-13));
    }
}

TEST_CASE("powers in a Chebyshev polynomial") {
    const Eigen::MatrixXd powers = chebyshev_by_powers(5);
    const Eigen::VectorXd fourth = powers.col(4);  // 8 x^4 - 8 x^2 + 1
    CHECK(fourth == Eigen::VectorXd{{1.0, 0.0, -8.0, 0.0, 8.0}});
    const Eigen::VectorXd third = powers.col(3);
    CHECK(third == Eigen::VectorXd{{0.0, -3.0, 0.0, 4.0, 0.0}});
}

TEST_CASE(
    "inverse interpolation keeps every point until it is full, even where zero is nearer to the wanted "
    "value") {
    InverseInterpolation<3> parabola(0.1);  // x = f^2 is its own interpolation through three points
    for (const double f : {1.0, 0.9, 0.8}) parabola.insert({.value = f, .x = f * f});
    CHECK(parabola.count() == 3);
    CHECK(parabola.nearest().value == 0.8);
    CHECK(parabola.interpolated() == doctest::Approx(0.01).epsilon(1e-13));
}

TEST_CASE("inverse interpolation that is full drops the point farthest from the wanted value") {
    InverseInterpolation<2> line(1.0);
    for (const double f : {0.7, 3.0, 1.2, 2.0}) line.insert({.value = f, .x = 10.0 * f});
    line.insert({.value = 5.0, .x = 0.0});  // is the farthest itself
    CHECK(line.count() == 2);
    CHECK(line.nearest().value == 1.2);
    CHECK(line.interpolated() == doctest::Approx(10.0).epsilon(1e-13));
}

TEST_CASE("an interval is open where no bound is known") {
    InverseInterpolation<2> search(1.0);
    CHECK(search.contains(1e300));
    search.bound(2.0, true);
    search.bound(5.0, false);
    CHECK_FALSE(search.contains(2.0));
    CHECK(search.contains(3.0));
    CHECK_FALSE(search.contains(5.0));
    CHECK(search.lower() == 2.0);
    CHECK(search.upper() == 5.0);
}

TEST_CASE("a least-median fit passes by two fifths of the points, whatever they say") {
    test::Random random(3);
    for (int round = 0; round < 20; ++round) {
        constexpr Eigen::Index count = 50;
        Eigen::MatrixXd design(count, 3);
        Eigen::VectorXd observed(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const double x = random.uniform(0.0, 1.0);
            design.row(i) << 1.0, x, x * x;
            observed[i] = 2.0 - 3.0 * x + 1.5 * x * x + random.normal(0.01);
            if (i % 5 < 2) observed[i] = random.uniform(5.0, 20.0);
        }
        const auto found = least_median(design, observed, [](const auto&) { return true; });
        REQUIRE(found);
        for (const double x : {0.0, 0.5, 1.0})
            CHECK(std::abs((*found)[0] + (*found)[1] * x + (*found)[2] * x * x - 2.0 + 3.0 * x -
                           1.5 * x * x) < 0.15);
    }
}

TEST_CASE("a least-median fit is one that is allowed, and none of rows that are alike") {
    const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(9, 2);
    CHECK_FALSE(least_median(ones, Eigen::VectorXd::Ones(9), [](const auto&) { return true; }));
    Eigen::MatrixXd design(4, 1);
    design << 1.0, 1.0, 1.0, 1.0;
    const Eigen::VectorXd observed = Eigen::Vector4d(1.0, 1.0, 1.0, 7.0);
    const auto most = least_median(design, observed, [](const auto&) { return true; });
    REQUIRE(most);
    CHECK(std::abs((*most)[0] - 1.0) < 1e-15);
    const auto allowed = least_median(design, observed, [](const auto& c) { return c[0] > 2.0; });
    REQUIRE(allowed);
    CHECK(std::abs((*allowed)[0] - 7.0) < 1e-14);
}

namespace {

Polynomial<double> polynomial(std::initializer_list<double> coefficients) {
    Polynomial<double> p;
    int power = 0;
    for (const double c : coefficients) p[power++] = c;
    p.degree = power - 1;
    return p;
}

const Polynomial<double> cubic = polynomial({-3.5e-9, 0.25, 7.0, -2.0});
const Polynomial<double> quadratic = polynomial({0.5, -1.25, 3.0});

constexpr double abscissae[] = {-1.7, -0.3, 0.0, 0.4, 2.6};

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

TEST_CASE("a polynomial's value is the sum of its terms") {
    for (const double x : abscissae)
        CHECK(std::abs(cubic(x) - (-3.5e-9 + 0.25 * x + 7.0 * x * x - 2.0 * x * x * x)) <
              1e-14 * (0.25 * std::abs(x) + 7.0 * x * x + 2.0 * std::abs(x * x * x) + 3.5e-9));
    CHECK(Polynomial<double>(4.25)(1e9) == 4.25);
    CHECK(Polynomial<double>::identity()(-0.7) == -0.7);
}

TEST_CASE("sums, differences, products and multiples of polynomials are those of their values") {
    for (const double x : abscissae) {
        CAPTURE(x);
        CHECK(relative_difference((cubic + quadratic)(x), cubic(x) + quadratic(x)) < 1e-14);
        CHECK(relative_difference((quadratic - cubic)(x), quadratic(x) - cubic(x)) < 1e-14);
        CHECK(relative_difference((cubic * quadratic)(x), cubic(x) * quadratic(x)) < 1e-14);
        CHECK(relative_difference((-2.5 * cubic)(x), -2.5 * cubic(x)) < 1e-14);
    }
    CHECK((cubic * quadratic).degree == 5);
    CHECK((quadratic + cubic).degree == 3);
}

TEST_CASE("the derivative undoes the antiderivative, which vanishes at zero") {
    const Polynomial<double> back = cubic.antiderivative().derivative();
    CHECK(back.degree == cubic.degree);
    for (int i = 0; i <= cubic.degree; ++i) CHECK(relative_difference(back[i], cubic[i]) < 1e-15);
    CHECK(cubic.antiderivative()(0.0) == 0.0);
    // 7 x^2 -> 14 x, -2 x^3 -> -6 x^2
    CHECK(cubic.derivative()[1] == 14.0);
    CHECK(cubic.derivative()[2] == -6.0);
    CHECK(Polynomial<double>(3.0).derivative()(5.0) == 0.0);
}

TEST_CASE("a shifted polynomial has the value of the offset place") {
    for (const double offset : {-2.0, 0.125, 3.0}) {
        for (const double x : abscissae) {
            CAPTURE(offset);
            CAPTURE(x);
            CHECK(std::abs(cubic.shifted(offset)(x) - cubic(x + offset)) < 1e-13);
        }
    }
}

TEST_CASE("an even polynomial is one of the square") {
    const Polynomial<double> even = polynomial({2.0, 0.0, -1.5, 0.0, 0.75});
    CHECK(even.even());
    CHECK(!cubic.even());
    CHECK(Polynomial<double>(1.0).even());
    CHECK(even.of_square().degree == 2);
    for (const double x : abscissae) CHECK(relative_difference(even.of_square()(x * x), even(x)) < 1e-15);
}

TEST_CASE("powers by multiplication and their roots") {
    const double x = 1.3e-3;
    CHECK(relative_difference(power<1>(x), x) == 0.0);
    CHECK(relative_difference(power<3>(x), x * x * x) < 1e-15);
    CHECK(relative_difference(power<6>(x), std::pow(x, 6)) < 1e-15);
    CHECK(relative_difference(root<2>(power<2>(x)), x) < 1e-15);
    CHECK(relative_difference(root<3>(power<3>(x)), x) < 1e-15);
    CHECK(relative_difference(root<4>(power<4>(x)), x) < 1e-15);
    CHECK(relative_difference(root<6>(power<6>(x)), x) < 1e-15);
}

TEST_CASE("an upper bound between two points is above every value there, and close on a short stretch") {
    for (const Polynomial<double>& p :
         {cubic, quadratic, polynomial({0.3}), polynomial({-1.0, 0.0, 0.0, 0.0, 2.0})}) {
        for (const double a : abscissae) {
            for (const double width : {3.0, 0.2, 1e-4}) {
                double greatest = p(a);
                for (int i = 0; i <= 100; ++i) greatest = std::max(greatest, p(a + width * i / 100.0));
                const double bound = p.upper_bound(a, a + width);
                CHECK(bound >= greatest - 1e-13 * std::abs(greatest));
                CHECK(bound - greatest <= 40.0 * width * width + 1e-13 * std::abs(greatest));
            }
        }
    }
    CHECK(quadratic.upper_bound(1.0, 2.0) == quadratic(2.0));  // reached at an end
}

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
        CHECK(relative_difference(square_coefficient(a, n), std::exp2(static_cast<double>(n)) * a[n]) <
              1e-14);
    }
    const Series<double> one{1.0};
    const Series<double> divisor{1.0, -2.0};
    Series<double> quotient{};  // 1/(1 - 2h)
    for (std::size_t n = 0; n < a.size(); ++n) {
        quotient[n] = quotient_coefficient(one, divisor, quotient, n);
        CHECK(quotient[n] == std::exp2(static_cast<double>(n)));
    }
}

TEST_CASE("the radius of a geometric series is its own, whatever its size") {
    for (const double r : {1e-9, 0.37, 5.0e3})
        for (const double factor : {1e-12, 1.0, 3e7})
            CHECK(relative_difference(radius(geometric(factor, r)), r) < 1e-13);
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
