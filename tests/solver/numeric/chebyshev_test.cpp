// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/chebyshev.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace ashimpact;

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
