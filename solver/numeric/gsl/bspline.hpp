// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include <Eigen/Dense>

namespace ashimpact::gsl {

/// Cubic B-splines on an interval (GSL bspline).
class BSpline {
  public:
    /// @param breaks strictly increasing, at least two @throws ConvergenceError
    explicit BSpline(std::span<const double> breaks);
    ~BSpline();
    BSpline(BSpline&&) noexcept;
    BSpline& operator=(BSpline&&) noexcept;

    [[nodiscard]] Eigen::Index size() const;
    /// The splines at @p x within the breaks. [1]
    [[nodiscard]] Eigen::VectorXd values(double x) const;
    /// Their first derivatives. [1/unit of x]
    [[nodiscard]] Eigen::VectorXd slopes(double x) const;

  private:
    struct Workspace;
    std::unique_ptr<Workspace> workspace_;
};

}  // namespace ashimpact::gsl
