// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace ashimpact {

/// An interval with Chebyshev-Lobatto nodes; degree 0 for a function that does not depend on the position.
struct ChebyshevAxis {
    static constexpr int greatest_degree = 47;

    double lower;
    double upper;
    int degree;

    /// Position of node @p i of 0 ... degree, from lower to upper.
    [[nodiscard]] double node(int i) const;
    /// Matrix that turns values at the nodes into coefficients of Chebyshev polynomials.
    [[nodiscard]] Eigen::MatrixXd analysis() const;
};

/// The Chebyshev polynomials of an axis and their slopes at one position; outside the interval they continue.
struct ChebyshevBasis {
    using Vector =
        Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, ChebyshevAxis::greatest_degree + 1, 1>;
    Vector value;
    Vector slope;

    ChebyshevBasis(const ChebyshevAxis& axis, double position);
};

/// The first @p terms Chebyshev polynomials by powers of their argument: column k holds T_k.
[[nodiscard]] Eigen::MatrixXd chebyshev_by_powers(int terms);

}  // namespace ashimpact
