// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/polynomial.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "solver/numeric/power.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using ashimpact::test::relative_difference;

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

constexpr double points[] = {-1.7, -0.3, 0.0, 0.4, 2.6};

}  // namespace

TEST_CASE("a polynomial's value is the sum of its terms") {
    for (const double x : points) {
        CHECK(std::abs(cubic(x) - (-3.5e-9 + 0.25 * x + 7.0 * x * x - 2.0 * x * x * x)) <
              1e-14 * (0.25 * std::abs(x) + 7.0 * x * x + 2.0 * std::abs(x * x * x) + 3.5e-9));
    }
    CHECK(Polynomial<double>(4.25)(1e9) == 4.25);
    CHECK(Polynomial<double>::identity()(-0.7) == -0.7);
}

TEST_CASE("sums, differences, products and multiples of polynomials are those of their values") {
    for (const double x : points) {
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
        for (const double x : points) {
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
    for (const double x : points) CHECK(relative_difference(even.of_square()(x * x), even(x)) < 1e-15);
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
        for (const double a : points) {
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
