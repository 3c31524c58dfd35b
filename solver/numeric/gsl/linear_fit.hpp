// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace ashimpact::gsl {

struct LinearFit {
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;  ///< for weights 1/sigma^2; if none are given, for unit weights
    double chi_squared = 0.0;    ///< not of a robust fit
    double deviation = 0.0;      ///< robust standard deviation of the residuals; of a robust fit alone
};

/// Weighted linear least squares y = X c by GSL multifit (SVD with balancing).
/// @param weights one per row, 1/sigma^2, or empty for unit weights
/// @throws ConvergenceError
[[nodiscard]] LinearFit fit_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations,
                                   const Eigen::VectorXd& weights);

/// Linear fit y = X c with Tukey's bisquare weights (GSL multifit_robust). @throws ConvergenceError
[[nodiscard]] LinearFit fit_linear_robust(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations);

/// Tukey's bisquare weights of residuals, relative to their median absolute deviation (GSL multifit_robust).
/// @param parameters number of fitted parameters, less than the number of residuals
/// @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd bisquare_weights(const Eigen::VectorXd& residuals, int parameters);

}  // namespace ashimpact::gsl
