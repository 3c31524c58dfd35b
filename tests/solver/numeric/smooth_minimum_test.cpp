#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "materials/base/error.hpp"
#include "solver/numeric/smooth_minimum.hpp"

using namespace ashimpact;

namespace {

SmoothFunction::Value nowhere(const Eigen::VectorXd& x) {
    return {std::numeric_limits<double>::infinity(), Eigen::VectorXd::Zero(x.size())};
}

}  // namespace

TEST_CASE("the minimum at the end of Rosenbrock's valley") {
    const SmoothFunction valley{[](const Eigen::VectorXd& x) -> SmoothFunction::Value {
        const double a = 1.0 - x[0];
        const double b = x[1] - x[0] * x[0];
        return {a * a + 100.0 * b * b, Eigen::Vector2d(-2.0 * a - 400.0 * x[0] * b, 200.0 * b)};
    }};
    const SmoothMinimum minimum = minimise(valley, Eigen::Vector2d(-1.2, 1.0));
    CHECK(minimum.converged);
    CHECK((minimum.place - Eigen::Vector2d(1.0, 1.0)).norm() < 1e-3);
    CHECK(minimum.value < 1e-6);
}

TEST_CASE("a search that begins where the function bends the wrong way") {
    // Minima at x = +-1, y = 0; the curvature along x is negative at the start.
    const SmoothFunction wells{[](const Eigen::VectorXd& p) -> SmoothFunction::Value {
        const double x = p[0];
        const double y = p[1];
        return {0.25 * std::pow(x * x - 1.0, 2) + 2.0 * y * y, Eigen::Vector2d(x * (x * x - 1.0), 4.0 * y)};
    }};
    const SmoothMinimum minimum = minimise(wells, Eigen::Vector2d(0.05, 0.7));
    CHECK(minimum.converged);
    CHECK(std::abs(minimum.place[0] - 1.0) < 1e-3);
    CHECK(std::abs(minimum.place[1]) < 1e-3);
}

TEST_CASE("steps into where the function is not defined are taken back") {
    // x - ln x, defined for x > 0 only.
    const SmoothFunction barrier{[](const Eigen::VectorXd& x) -> SmoothFunction::Value {
        if (!(x[0] > 0.0)) return nowhere(x);
        return {x[0] - std::log(x[0]), Eigen::VectorXd::Constant(1, 1.0 - 1.0 / x[0])};
    }};
    const SmoothMinimum minimum = minimise(barrier, Eigen::VectorXd::Constant(1, 6.0), {.first_step = 50.0});
    CHECK(minimum.converged);
    CHECK(std::abs(minimum.place[0] - 1.0) < 1e-3);
}

TEST_CASE("a search without an end, and one without a beginning") {
    const SmoothFunction slope{[](const Eigen::VectorXd& x) -> SmoothFunction::Value {
        return {x[0], Eigen::VectorXd::Constant(1, 1.0)};
    }};
    const SmoothMinimum none = minimise(slope, Eigen::VectorXd::Zero(1), {.most_evaluations = 20});
    CHECK_FALSE(none.converged);
    CHECK(none.evaluations == 20);
    CHECK_THROWS_AS(static_cast<void>(minimise({nowhere}, Eigen::VectorXd::Zero(2))), ConvergenceError);
}
