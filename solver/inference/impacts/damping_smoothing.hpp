// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "solver/inference/impacts/inversion.hpp"
#include "solver/numeric/gsl/interpolation.hpp"

namespace ashimpact {

/// Fewest rebounds that can be smoothed.
inline constexpr std::size_t least_smoothed = 8;

/// Damping over the logarithm of velocity as a robust cubic spline. Its knots lie at quantiles of the data,
/// and the corrected Akaike criterion chooses their number. Data without noise are interpolated: there the
/// neighbours of a point predict it better than such a spline does.
class DampingSmoothing {
  public:
    /// The smoothing of inverted impacts; none if fewer than least_smoothed rebounds have a damping, or fewer
    /// than four distinct velocities.
    [[nodiscard]] static std::optional<DampingSmoothing> of(const std::vector<InvertedImpact>& inverted);

    struct Value {
        double damping;                 ///< [kg/s]
        double standard_uncertainty;    ///< [kg/s]
        double elasticity;              ///< d ln eta/d ln v [1]
        double elasticity_uncertainty;  ///< standard [1]
    };
    /// @param velocity within [slowest(), fastest()] [m/s]
    [[nodiscard]] Value at(double velocity) const;
    [[nodiscard]] double slowest() const;
    [[nodiscard]] double fastest() const;
    /// Residual of each rebound in robust standard deviations, with its index in the set.
    struct Residual {
        std::size_t index;
        double value;
    };
    [[nodiscard]] const std::vector<Residual>& residuals() const { return residuals_; }

  private:
    struct Rows;

    /// With knots at @p breaks, without coefficients yet.
    DampingSmoothing(const Rows& rows, const std::vector<double>& breaks);

    gsl::BSpline splines_;
    Eigen::VectorXd coefficients_;
    Eigen::MatrixXd covariance_;
    std::vector<Residual> residuals_;
    double first_;  ///< ln v
    double last_;
    double criterion_ = 0.0;

    [[nodiscard]] static std::optional<DampingSmoothing> with_intervals(const Rows& rows, int intervals);
    [[nodiscard]] static std::optional<DampingSmoothing> robust(const Rows& rows);
    [[nodiscard]] static DampingSmoothing through(const Rows& rows);
    [[nodiscard]] std::vector<double> scaled_residuals(const Rows& rows) const;
};

}  // namespace ashimpact
