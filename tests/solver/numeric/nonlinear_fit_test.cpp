// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/fit.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/data_file.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

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
