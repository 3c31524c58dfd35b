// SPDX-License-Identifier: GPL-3.0-or-later
// The wrappers around GSL: roots, distributions, linear fits, and errors that come through.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>
#include <gsl/gsl_errno.h>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/fit.hpp"
#include "solver/numeric/gsl/search.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/numeric/gsl/support.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using ashimpact::test::relative_difference;

TEST_CASE("a root is found to the tolerance asked for") {
    const auto cubic = [](double x) { return x * x * x - 2e-21; };  // root 1.26e-7
    const gsl::RootSummary found = gsl::brent(cubic, 0.0, 1e-6);
    CHECK(relative_difference(found.root, std::cbrt(2e-21)) < 1e-12);
    CHECK(found.iterations > 0);
    const gsl::RootSummary rough = gsl::brent(cubic, 0.0, 1e-6, {.relative = 1e-2});
    CHECK(relative_difference(rough.root, std::cbrt(2e-21)) < 1e-2);
    CHECK(rough.iterations < found.iterations);
}

TEST_CASE("a bracket without a sign change, or too few iterations, do not converge") {
    const auto square = [](double x) { return x * x + 1.0; };
    CHECK_THROWS_AS(static_cast<void>(gsl::brent(square, -1.0, 1.0)), ConvergenceError);
    const auto step = [](double x) { return std::atan(1e9 * (x - 0.3)); };
    CHECK_THROWS_AS(static_cast<void>(gsl::brent(step, 0.0, 1.0, {.most_iterations = 2})), ConvergenceError);
}

TEST_CASE("what the function throws comes out of GSL unchanged") {
    const auto throwing = [](double x) -> double {
        if (x > 0.4) throw InputError("the function gave up");
        return x - 0.7;
    };
    CHECK_THROWS_WITH_AS(static_cast<void>(gsl::brent(throwing, 0.0, 1.0)), "the function gave up",
                         InputError);
    const auto later = [calls = 0](double x) mutable -> double {
        if (++calls > 4) throw std::runtime_error("later");
        return std::exp(x) - 1.5;
    };
    CHECK_THROWS_WITH_AS(static_cast<void>(gsl::brent(later, 0.0, 1.0)), "later", std::runtime_error);
}

TEST_CASE("normal quantiles and chi^2 exceedance") {
    CHECK(relative_difference(gsl::normal_quantile(0.975), 1.959963984540054) < 1e-14);
    CHECK(std::abs(gsl::normal_quantile(0.5)) < 1e-15);
    // With eight degrees of freedom Q = exp(-x/2) (1 + y + y^2/2 + y^3/6), y = x/2.
    const double y = 7.85 / 2.0;
    const double closed = std::exp(-y) * (1.0 + y + y * y / 2.0 + y * y * y / 6.0);
    CHECK(relative_difference(gsl::chi_squared_exceedance(7.85, 8), closed) < 1e-13);
    CHECK(gsl::chi_squared_exceedance(7.85, 0) == 1.0);
    CHECK(gsl::chi_squared_exceedance(0.0, 3) == 1.0);
}

TEST_CASE("a simplex finds minima of curved valleys and at kinks, and lets exceptions through") {
    // Rosenbrock's valley in units a thousand times apart, and the point of least distances to three others:
    // on an axis of symmetry, where the distances meet at 120 degrees (Fermat).
    const auto valley = [](const Eigen::VectorXd& x) {
        const double a = 1e3 * x[0];
        return std::pow(1.0 - a, 2) + 100.0 * std::pow(x[1] - a * a, 2);
    };
    const Eigen::VectorXd lowest =
        gsl::minimise(valley, Eigen::Vector2d(-1.2e-3, 1.0), Eigen::Vector2d(1e-4, 0.1));
    CHECK(std::abs(1e3 * lowest[0] - 1.0) < 1e-4);
    CHECK(std::abs(lowest[1] - 1.0) < 2e-4);
    const auto distances = [](const Eigen::VectorXd& x) {
        return std::hypot(x[0] + 1.0, x[1]) + std::hypot(x[0] - 1.0, x[1]) + std::hypot(x[0], x[1] - 3.0);
    };
    const Eigen::VectorXd fermat =
        gsl::minimise(distances, Eigen::Vector2d(2.0, 2.0), Eigen::Vector2d(1.0, 1.0));
    CHECK(std::abs(fermat[0]) < 1e-4);
    CHECK(std::abs(fermat[1] - 1.0 / std::sqrt(3.0)) < 1e-4);
    const auto kink = [](const Eigen::VectorXd& x) { return std::abs(x[0] - 0.3) + std::abs(x[0] + x[1]); };
    const Eigen::VectorXd edge = gsl::minimise(kink, Eigen::Vector2d(5.0, 4.0), Eigen::Vector2d(0.5, 0.5));
    CHECK(std::abs(edge[0] - 0.3) < 1e-5);
    CHECK(std::abs(edge[1] + 0.3) < 1e-5);
    const auto throwing = [](const Eigen::VectorXd& x) -> double {
        if (x[0] < 0.5) throw InputError("too far");
        return x.squaredNorm();
    };
    CHECK_THROWS_WITH_AS(
        static_cast<void>(gsl::minimise(throwing, Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(0.2, 0.2))),
        "too far", InputError);
}

TEST_CASE("the minimum between two ends, of smooth functions and of those that are infinite beyond a place") {
    const auto well = [](double x) { return std::cosh(x - 0.7); };
    CHECK(std::abs(gsl::minimise_between(well, -3.0, 0.0, 2.0, 1e-8) - 0.7) < 1e-6);
    CHECK(std::abs(gsl::minimise_between(well, -3.0, 0.0, 2.0) - 0.7) < 5e-4);
    const auto walled = [](double x) { return x < 0.5 ? std::numeric_limits<double>::infinity() : x * x; };
    CHECK(std::abs(gsl::minimise_between(walled, 0.0, 0.9, 2.0, 1e-6) - 0.5) < 1e-5);
    CHECK(gsl::minimise_between([](double x) { return x; }, 0.0, 0.5, 1.0) == 0.5);  // no minimum between
    const auto throwing = [](double x) -> double {
        if (x > 0.9) throw InputError("too far");
        return x * x;
    };
    CHECK_THROWS_WITH_AS(static_cast<void>(gsl::minimise_between(throwing, -1.0, 0.5, 1.0)), "too far",
                         InputError);
}

TEST_CASE("a weighted mean is the simplest linear fit") {
    const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(3, 1);
    const Eigen::Vector3d values(1e-7, 2e-7, 4e-7);
    const Eigen::Vector3d weights(1e16, 4e16, 5e16);
    const gsl::LinearFit fit = gsl::fit_linear(ones, values, weights);
    CHECK(relative_difference(fit.parameters[0], (1.0 + 8.0 + 20.0) / 10.0 * 1e-7) < 1e-14);
    CHECK(relative_difference(fit.covariance(0, 0), 1.0 / 1e17) < 1e-14);
    CHECK(relative_difference(fit.chi_squared, 1.9 * 1.9 * 100 + 4 * 0.81 * 100 + 5 * 1.21 * 100) < 1e-12);
    const gsl::LinearFit plain = gsl::fit_linear(ones, values, {});
    CHECK(relative_difference(plain.parameters[0], 7e-7 / 3.0) < 1e-14);
}

TEST_CASE("a failed status is an error with GSL's words") {
    CHECK_NOTHROW(gsl::check(0, "nothing"));
    CHECK_THROWS_WITH_AS(gsl::check(1, "a step"), "a step: input domain error", ConvergenceError);
    for (const int status : {GSL_EBADFUNC, GSL_EFAILED, GSL_ENOPROG})  // its words for programmers
        CHECK_THROWS_WITH_AS(gsl::check(status, "a step"),
                             "a step: the function has no finite value there, or the search gets no further",
                             ConvergenceError);
}
