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

struct SurfacePoint {
    double value;
    double by_x;  ///< derivative along x
    double by_y;  ///< derivative along y
};

/// A smooth function of two variables as a polynomial through its values at Chebyshev nodes.
class ChebyshevSurface {
  public:
    ChebyshevSurface() = default;
    /// @param values value at (x node of the row, y node of the column)
    ChebyshevSurface(const ChebyshevAxis& x, const ChebyshevAxis& y, const Eigen::MatrixXd& values);

    /// Value and slopes at a point of the rectangle; outside it the polynomial is continued.
    [[nodiscard]] SurfacePoint operator()(double x, double y) const;
    /// The value alone.
    [[nodiscard]] double value(double x, double y) const;

  private:
    ChebyshevAxis x_{0.0, 1.0, 0};
    ChebyshevAxis y_{0.0, 1.0, 0};
    Eigen::MatrixXd coefficients_ = Eigen::MatrixXd::Zero(1, 1);
};

}  // namespace ashimpact
