// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Dense>

namespace ashimpact::gsl {

/// Cubic B-splines on an interval (GSL bspline). Threads may share one.
class BSpline {
  public:
    /// @param breaks strictly increasing, at least two @throws ConvergenceError
    explicit BSpline(std::span<const double> breaks);

    [[nodiscard]] Eigen::Index size() const;
    /// The splines at @p x within the breaks, or their derivative of order 1 [1/unit of x^derivative].
    [[nodiscard]] Eigen::VectorXd values(double x, int derivative = 0) const;

  private:
    struct Workspace;
    std::unique_ptr<Workspace, void (*)(Workspace*)> workspace_;
};

struct QuadratureNode {
    double position;
    double weight;
};

/// Gauss-Legendre nodes of an interval (GSL integration): exact for polynomials of degree 2 count - 1.
[[nodiscard]] std::vector<QuadratureNode> gauss_legendre(int count, double lower, double upper);

}  // namespace ashimpact::gsl

namespace ashimpact {

/// A measured curve, interpolated without overshoot between its points (Steffen 1990, by GSL): monotone
/// data stay monotone, and no value lies outside its two neighbours.
class MeasuredCurve {
  public:
    /// @param x strictly increasing; @param y as long as x, at least 3 points, all finite
    /// @throws InputError
    MeasuredCurve(std::span<const double> x, std::span<const double> y);

    /// Value at @p x [unit of y]. @throws InputError outside the measured range: nothing is extrapolated
    [[nodiscard]] double operator()(double x) const;
    [[nodiscard]] double lower() const;  ///< first abscissa [unit of x]
    [[nodiscard]] double upper() const;  ///< last abscissa [unit of x]

  private:
    struct Spline;
    std::shared_ptr<const Spline> spline_;
};

}  // namespace ashimpact
