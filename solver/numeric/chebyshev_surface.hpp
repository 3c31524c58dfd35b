// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/numeric/chebyshev.hpp"

namespace ashimpact {

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

  private:
    ChebyshevAxis x_{0.0, 1.0, 0};
    ChebyshevAxis y_{0.0, 1.0, 0};
    Eigen::MatrixXd coefficients_ = Eigen::MatrixXd::Zero(1, 1);
};

}  // namespace ashimpact
