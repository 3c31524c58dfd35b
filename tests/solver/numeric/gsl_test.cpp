// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <gsl/gsl_errno.h>
#include <nlohmann/json.hpp>

#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/numeric/gsl/support.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/published.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

// The wrappers around GSL: roots, distributions, linear fits, and errors that come through.

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

namespace {

/// Restitution over incident velocity, rising steeply from capture and falling slowly [m/s], [1].
const std::vector<double> velocities{1.92, 2.0, 2.2, 3.1, 5.0, 9.0, 14.0};
const std::vector<double> restitutions{0.0, 0.31, 0.52, 0.66, 0.68, 0.61, 0.50};

using Model = double (*)(const Eigen::VectorXd& b, double x);

double misra1a(const Eigen::VectorXd& b, double x) {
    return b[0] * (1.0 - std::exp(-b[1] * x));
}

double thurber(const Eigen::VectorXd& b, double x) {
    return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])));
}

double mgh09(const Eigen::VectorXd& b, double x) {
    return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]);
}

Eigen::VectorXd vector_of(const nlohmann::json& column) {
    const auto values = column.get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A problem of NIST's Statistical Reference Datasets, tests/data/nist.
struct Certified {
    Model model;
    nlohmann::json data;
    Eigen::VectorXd x = vector_of(data["x"]);
    Eigen::VectorXd y = vector_of(data["y"]);

    [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& b) const {
        Eigen::VectorXd r(x.size());
        for (Eigen::Index i = 0; i < x.size(); ++i) r[i] = model(b, x[i]) - y[i];
        return r;
    }
    [[nodiscard]] double number(const char* key) const { return data[key].get<double>(); }
};

Certified misra_problem() {
    return {&misra1a, data_file("nist/misra1a.json")};
}

/// Six digits in everything that is certified, from one published start.
void check_certified(const Certified& problem, const Eigen::VectorXd& start) {
    const gsl::NonlinearFit fit = gsl::fit_nonlinear(
        {[&](const Eigen::VectorXd& b) { return problem.residuals(b); }}, start, {.most_iterations = 2000});
    const Eigen::VectorXd parameters = vector_of(problem.data["parameters"]);
    const Eigen::VectorXd deviations = vector_of(problem.data["standard_deviations"]);
    const double deviation = std::sqrt(fit.chi_squared / problem.number("degrees_of_freedom"));
    CHECK(relative_difference(fit.chi_squared, problem.number("residual_sum_of_squares")) < 1e-9);
    CHECK(relative_difference(deviation, problem.number("residual_standard_deviation")) < 1e-9);
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
        CAPTURE(i);
        CHECK(relative_difference(fit.parameters[i], parameters[i]) < 1e-6);
        CHECK(relative_difference(deviation * std::sqrt(fit.covariance(i, i)), deviations[i]) < 1e-6);
    }
    CHECK(relative_difference(fit.residuals.squaredNorm(), fit.chi_squared) < 1e-14);
}

}  // namespace

TEST_CASE("a measured curve passes through its points") {
    const MeasuredCurve curve(velocities, restitutions);
    CHECK(curve.lower() == 1.92);
    CHECK(curve.upper() == 14.0);
    for (std::size_t i = 0; i < velocities.size(); ++i)
        CHECK(std::abs(curve(velocities[i]) - restitutions[i]) < 1e-15);
}

TEST_CASE("no value lies outside its two neighbours, and between them the curve is monotone") {
    Random random(5);
    for (int curve_number = 0; curve_number < 50; ++curve_number) {
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i < 8; ++i) {
            x.push_back((x.empty() ? 0.0 : x.back()) + random.log_uniform(1e-3, 10.0));
            y.push_back(random.uniform(0.0, 1.0));
        }
        const MeasuredCurve curve(x, y);
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            double before = y[i];
            const double lower = std::min(y[i], y[i + 1]) - 1e-15;
            const double upper = std::max(y[i], y[i + 1]) + 1e-15;
            const double direction = y[i + 1] - y[i];
            bool inside = true;
            bool monotone = true;
            for (int k = 1; k <= 40; ++k) {
                const double value = curve(std::min(x[i] + (x[i + 1] - x[i]) * k / 40.0, x[i + 1]));
                inside = inside && value >= lower && value <= upper;
                monotone = monotone && (value - before) * direction >= -1e-15;
                before = value;
            }
            CHECK(inside);
            CHECK(monotone);
        }
    }
}

TEST_CASE("a straight line stays straight, a step stays a step") {
    const std::vector<double> x{0.5, 1.0, 2.5, 4.0};
    const std::vector<double> line{1.0, 2.0, 5.0, 8.0};
    const MeasuredCurve straight(x, line);
    for (int i = 0; i < 10; ++i) {
        const double at = 0.5 + 0.37 * i;
        CHECK(relative_difference(straight(at), 2.0 * at) < 1e-14);
    }
    const std::vector<double> step{0.0, 0.0, 1.0, 1.0};
    const MeasuredCurve jump(x, step);
    CHECK(jump(0.7) == 0.0);
    CHECK(jump(3.3) == 1.0);
    CHECK(std::abs(jump(1.75) - 0.5) < 1e-15);
}

TEST_CASE("nothing is extrapolated") {
    const MeasuredCurve curve(velocities, restitutions);
    CHECK(input_error_of([&] { return curve(1.9); }) ==
          "a measured curve is asked for its value at 1.900000; allowed: 1.920000 to 14.000000, the measured "
          "range");
    CHECK_THROWS_AS(static_cast<void>(curve(14.1)), InputError);
    CHECK_THROWS_AS(static_cast<void>(curve(std::numeric_limits<double>::quiet_NaN())), InputError);
}

TEST_CASE("curves that are none are refused") {
    const auto message = [](std::vector<double> x, std::vector<double> y) {
        return input_error_of([&] { MeasuredCurve(x, y); });
    };
    CHECK(message({1, 2}, {1, 2}) ==
          "a measured curve has 2 abscissae and 2 values; allowed: as many of both, at least 3");
    CHECK(contains(message({1, 2, 3}, {1, 2}), "has 3 abscissae and 2 values"));
    CHECK(message({1, 3, 2}, {1, 2, 3}) ==
          "point 3 of a measured curve is out of order or not finite; allowed: finite values, abscissae "
          "strictly increasing");
    CHECK(contains(message({1, 1, 2}, {1, 2, 3}), "point 2 of a measured curve"));
    CHECK(contains(message({1, 2, 3}, {1, std::nan(""), 3}), "point 2 of a measured curve"));
    CHECK(contains(message({std::nan(""), 2, 3}, {1, 2, 3}), "point 1 of a measured curve"));
}

TEST_CASE("a curve can be moved") {
    MeasuredCurve first(velocities, restitutions);
    const double value = first(2.7);
    MeasuredCurve second(std::move(first));
    CHECK(second(2.7) == value);
    MeasuredCurve third(std::vector<double>{1, 2, 3}, std::vector<double>{1, 2, 3});
    third = std::move(second);
    CHECK(third(2.7) == value);
}

TEST_CASE("NIST StRD: certified values to six digits from both published starts") {
    const std::array<Certified, 3> problems{misra_problem(),
                                            Certified{&thurber, data_file("nist/thurber.json")},
                                            Certified{&mgh09, data_file("nist/mgh09.json")}};
    for (const Certified& problem : problems) {
        CAPTURE(problem.data["model"].get<std::string>());
        REQUIRE(problem.data["starts"].size() == 2);
        for (const nlohmann::json& start : problem.data["starts"]) {
            CAPTURE(start.dump());
            check_certified(problem, vector_of(start));
        }
    }
}

TEST_CASE("an exact model is recovered at any scale") {
    const Eigen::Vector2d truth(3.2e-9, 47.0);
    const auto residuals = [&](const Eigen::VectorXd& b) {
        Eigen::VectorXd r(5);
        for (int i = 0; i < 5; ++i) {
            const double x = 0.01 * (i + 1);
            r[i] = 1e9 * (b[0] * std::exp(-b[1] * x) - truth[0] * std::exp(-truth[1] * x));
        }
        return r;
    };
    const gsl::NonlinearFit fit = gsl::fit_nonlinear({residuals}, Eigen::Vector2d(1e-9, 30.0));
    CHECK(relative_difference(fit.parameters[0], truth[0]) < 1e-9);
    CHECK(relative_difference(fit.parameters[1], truth[1]) < 1e-9);
    CHECK(fit.chi_squared < 1e-18);
}

TEST_CASE("too few iterations are a failure, not an answer, in whatever unit the residuals are") {
    const Certified misra = misra_problem();
    for (const double unit : {1e-6, 1.0, 1e6}) {
        CAPTURE(unit);
        const auto residuals = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd {
            return unit * misra.residuals(b);
        };
        const Eigen::Vector2d start(500.0, 1e-4);
        CHECK_THROWS_AS(static_cast<void>(gsl::fit_nonlinear({residuals}, start, {.most_iterations = 2})),
                        ConvergenceError);
        CHECK(relative_difference(gsl::fit_nonlinear({residuals}, start).parameters[0],
                                  misra.data["parameters"][0].get<double>()) < 1e-6);
    }
}

TEST_CASE("what the residuals throw comes out of GSL unchanged") {
    const Certified misra = misra_problem();
    const auto throwing = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd {
        if (b[0] != 500.0) throw InputError("no such parameter");
        return misra.residuals(b);
    };
    CHECK_THROWS_WITH_AS(static_cast<void>(gsl::fit_nonlinear({throwing}, Eigen::Vector2d(500.0, 1e-4))),
                         "no such parameter", InputError);
}

TEST_CASE("threads that share B-splines get the values of one thread") {
    const gsl::BSpline splines(std::array{0.0, 0.3, 0.5, 1.0});
    std::vector<double> positions(20'000);
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = static_cast<double>(i) / static_cast<double>(positions.size());
    const auto value = [&](double x) { return splines.values(x); };
    const auto shared = in_parallel(positions, value);
    for (std::size_t i = 0; i < positions.size(); ++i) REQUIRE(shared[i] == value(positions[i]));
}
