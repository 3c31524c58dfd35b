// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include "solver/inference/calibration/reconstruction.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

using LongMatrix = Eigen::Matrix<long double, 3, 3>;
using LongVector = Eigen::Matrix<long double, 3, 1>;

/// Fit and covariance by the normal equations in extended precision, which share nothing with the SVD of the
/// fit; of the coefficients in ascending powers.
struct NormalEquations {
    LongVector coefficients = LongVector::Zero();
    LongMatrix inverse = LongMatrix::Zero();
    long double chi_squared = 0;

    explicit NormalEquations(const std::vector<DampingPoint>& points) {
        const auto weight = [](const DampingPoint& p) {
            const long double u = p.standard_uncertainty;
            return u > 0 ? 1 / (u * u) : 1.0L;
        };
        const auto row = [](const DampingPoint& p) {
            const long double e = p.restitution;
            return LongVector(1, e, e * e);
        };
        LongMatrix normal = LongMatrix::Zero();
        LongVector right = LongVector::Zero();
        for (const DampingPoint& p : points) {
            normal += weight(p) * row(p) * row(p).transpose();
            right += weight(p) * p.damping * row(p);
        }
        inverse = normal.inverse();
        coefficients = inverse * right;
        for (const DampingPoint& p : points)
            chi_squared += weight(p) * std::pow(p.damping - row(p).dot(coefficients), 2.0L);
    }
};

/// Noisy points on the 88 um Hertz row of Table 2.
std::vector<DampingPoint> noisy_points(bool weighted) {
    Random random(42);
    std::vector<DampingPoint> points;
    for (int i = 0; i < 12; ++i) {
        const double e = 0.05 + 0.05 * i;
        const double u = weighted ? 1e-4 * (1.0 + 0.3 * i) : 0.0;
        const double noise = random.uniform(-2e-4, 2e-4);
        points.push_back({e, 0.0238 * e * e - 0.0291 * e + 0.0153 + noise, u});
    }
    return points;
}

void check_against_normal_equations(const DampingFit& fit, const NormalEquations& expected,
                                    long double scatter) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        CHECK(relative_difference(fit.damping.coefficients[i],
                                  static_cast<double>(expected.coefficients[i])) < 1e-12);
        for (Eigen::Index j = 0; j < 3; ++j) {
            CAPTURE(i);
            CAPTURE(j);
            CHECK(relative_difference(fit.covariance(i, j),
                                      static_cast<double>(scatter * expected.inverse(i, j))) < 1e-11);
        }
    }
    CHECK(relative_difference(fit.chi_squared, static_cast<double>(expected.chi_squared)) < 1e-11);
}

}  // namespace

TEST_CASE("an exact quadratic is recovered, with its critical damping") {
    std::vector<DampingPoint> points;
    for (int i = 0; i < 13; ++i) {
        const double e = 0.1 + 0.05 * i;
        points.push_back({e, (0.0193 * e - 0.0247) * e + 0.0141, 0.0});
    }
    const DampingFit fit = fit_damping(points);
    CHECK(relative_difference(fit.damping.coefficients[2], 0.0193) < 1e-12);
    CHECK(relative_difference(fit.damping.coefficients[1], -0.0247) < 1e-12);
    CHECK(relative_difference(fit.damping.coefficients[0], 0.0141) < 1e-12);
    CHECK(fit.damping.critical_damping() == fit.damping.coefficients[0]);
    CHECK(relative_difference(fit.damping(0.4), 0.0193 * 0.16 - 0.0247 * 0.4 + 0.0141) < 1e-12);
    CHECK(fit.degrees_of_freedom == static_cast<int>(points.size()) - 3);
    CHECK(fit.residual_deviation < 1e-16);
}

TEST_CASE("with uncertainties: parameters, covariance and chi^2 are those of the normal equations") {
    const auto points = noisy_points(true);
    const DampingFit fit = fit_damping(points);
    check_against_normal_equations(fit, NormalEquations(points), 1.0L);
    CHECK(fit.degrees_of_freedom == 9);
    CHECK(fit.chi_squared > 1.0);
}

TEST_CASE("without uncertainties the covariance is scaled by the scatter of the residuals") {
    const auto points = noisy_points(false);
    const DampingFit fit = fit_damping(points);
    const NormalEquations expected(points);
    check_against_normal_equations(fit, expected, expected.chi_squared / 9);
    CHECK(relative_difference(fit.residual_deviation,
                              static_cast<double>(std::sqrt(expected.chi_squared / 9))) < 1e-12);
}

TEST_CASE("equal uncertainties fit like none, and the covariance goes with their square") {
    auto points = noisy_points(false);
    const DampingFit plain = fit_damping(points);
    for (DampingPoint& p : points) p.standard_uncertainty = 1e-4;
    const DampingFit one = fit_damping(points);
    for (DampingPoint& p : points) p.standard_uncertainty = 3e-4;
    const DampingFit three = fit_damping(points);
    CHECK(relative_difference(plain.damping.coefficients[2], one.damping.coefficients[2]) < 1e-12);
    CHECK(relative_difference(one.damping.coefficients[2], three.damping.coefficients[2]) < 1e-12);
    CHECK(relative_difference(three.covariance(0, 1), 9.0 * one.covariance(0, 1)) < 1e-11);
    CHECK(relative_difference(one.chi_squared, 9.0 * three.chi_squared) < 1e-11);
}

TEST_CASE("three points are interpolated and leave no scatter") {
    const std::vector<DampingPoint> points{{0.1, 0.013, 0.0}, {0.3, 0.009, 0.0}, {0.6, 0.0065, 0.0}};
    const DampingFit fit = fit_damping(points);
    CHECK(fit.degrees_of_freedom == 0);
    for (const DampingPoint& p : points)
        CHECK(relative_difference(fit.damping(p.restitution), p.damping) < 1e-13);
    CHECK(fit.covariance.cwiseAbs().maxCoeff() < 1e-30);
}

TEST_CASE("too few, unequal or impossible points are refused") {
    const auto message = [](std::vector<DampingPoint> points) {
        return input_error_of([&] { static_cast<void>(fit_damping(points)); });
    };
    CHECK(message({}) == "the damping fit has 0 distinct restitutions; allowed: at least 3 for a quadratic");
    CHECK(contains(message({{0.1, 0.01, 0}, {0.2, 0.01, 0}}), "has 2 distinct restitutions"));
    CHECK(contains(message({{0.1, 0.01, 0}, {0.2, 0.01, 0}, {0.2, 0.011, 0}, {0.1, 0.012, 0}}),
                   "has 2 distinct restitutions"));
    CHECK(message({{0.1, 0.01, 1e-4}, {0.2, 0.01, 0}, {0.3, 0.01, 1e-4}}) ==
          "only some points of the damping fit have an uncertainty; allowed: all of them or none");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const DampingPoint& wrong : {DampingPoint{nan, 0.01, 0}, DampingPoint{0.3, infinity, 0},
                                      DampingPoint{0.3, 0.01, -1e-4}, DampingPoint{0.3, 0.01, nan}}) {
        CHECK(contains(message({{0.1, 0.01, 0}, {0.2, 0.01, 0}, {0.4, 0.01, 0}, wrong}),
                       "is not finite or has a negative uncertainty"));
    }
}
