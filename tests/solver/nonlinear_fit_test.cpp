#include "solver/gsl/nonlinear_fit.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "materials/error.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using ashimpact::test::relative_difference;

namespace {

/// NIST StRD nonlinear regression, Misra1a (D. Misra 1978, dental research in monomolecular adsorption):
/// volume y over pressure x, y = b1 (1 - exp(-b2 x)).
/// https://www.itl.nist.gov/div898/strd/nls/data/misra1a.shtml
constexpr std::array<double, 14> volume{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                        44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};
constexpr std::array<double, 14> pressure{77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                          378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};

struct Certified {
    double value;
    double standard_deviation;
};
constexpr Certified certified_b1{2.3894212918e+02, 2.7070075241e+00};
constexpr Certified certified_b2{5.5015643181e-04, 7.2668688436e-06};
constexpr double certified_sum_of_squares = 1.2455138894e-01;
constexpr double certified_deviation = 1.0187876330e-01;

Eigen::VectorXd misra(const Eigen::VectorXd& b) {
    Eigen::VectorXd residuals(static_cast<Eigen::Index>(volume.size()));
    for (std::size_t i = 0; i < volume.size(); ++i) {
        residuals[static_cast<Eigen::Index>(i)] = b[0] * (1.0 - std::exp(-b[1] * pressure[i])) - volume[i];
    }
    return residuals;
}

}  // namespace

TEST_CASE("NIST Misra1a: certified parameters, sum of squares and standard deviations, from both starts") {
    for (const Eigen::Vector2d& start : {Eigen::Vector2d(500.0, 1e-4), Eigen::Vector2d(250.0, 5e-4)}) {
        const gsl::NonlinearFit fit = gsl::fit_nonlinear(misra, start);
        CHECK(relative_difference(fit.parameters[0], certified_b1.value) < 1e-8);
        CHECK(relative_difference(fit.parameters[1], certified_b2.value) < 1e-8);
        CHECK(relative_difference(fit.chi_squared, certified_sum_of_squares) < 1e-9);
        const double deviation = std::sqrt(fit.chi_squared / 12.0);
        CHECK(relative_difference(deviation, certified_deviation) < 1e-9);
        CHECK(relative_difference(deviation * std::sqrt(fit.covariance(0, 0)),
                                  certified_b1.standard_deviation) < 1e-6);
        CHECK(relative_difference(deviation * std::sqrt(fit.covariance(1, 1)),
                                  certified_b2.standard_deviation) < 1e-6);
        CHECK(relative_difference(fit.residuals.squaredNorm(), fit.chi_squared) < 1e-14);
        CHECK(fit.iterations > 1);
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
    const gsl::NonlinearFit fit = gsl::fit_nonlinear(residuals, Eigen::Vector2d(1e-9, 30.0));
    CHECK(relative_difference(fit.parameters[0], truth[0]) < 1e-9);
    CHECK(relative_difference(fit.parameters[1], truth[1]) < 1e-9);
    CHECK(fit.chi_squared < 1e-18);
}

TEST_CASE("too few iterations are a failure, not an answer") {
    CHECK_THROWS_AS(
        static_cast<void>(gsl::fit_nonlinear(misra, Eigen::Vector2d(500.0, 1e-4), {.most_iterations = 1})),
        ConvergenceError);
}

TEST_CASE("what the residuals throw comes out of GSL unchanged") {
    const auto throwing = [](const Eigen::VectorXd& b) -> Eigen::VectorXd {
        if (b[0] != 500.0) throw InputError("no such parameter");
        return misra(b);
    };
    CHECK_THROWS_WITH_AS(static_cast<void>(gsl::fit_nonlinear(throwing, Eigen::Vector2d(500.0, 1e-4))),
                         "no such parameter", InputError);
}
