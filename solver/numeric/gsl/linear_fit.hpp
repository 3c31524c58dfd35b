// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace ashimpact::gsl {

struct LinearFit {
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;  ///< for weights 1/sigma^2; if none are given, for unit weights
    double chi_squared;
};

/// Weighted linear least squares y = X c by GSL multifit (SVD with balancing).
/// @param weights one per row, 1/sigma^2, or empty for unit weights
/// @throws ConvergenceError
[[nodiscard]] LinearFit fit_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations,
                                   const Eigen::VectorXd& weights);

}  // namespace ashimpact::gsl
