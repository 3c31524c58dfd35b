// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace ashimpact::gsl {

/// Tukey's bisquare weights of residuals, relative to their median absolute deviation (GSL multifit_robust).
/// @param parameters number of fitted parameters, less than the number of residuals
/// @throws ConvergenceError
[[nodiscard]] Eigen::VectorXd bisquare_weights(const Eigen::VectorXd& residuals, int parameters);

struct RobustLinearFit {
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;
    Eigen::VectorXd residuals;
    double deviation;  ///< robust standard deviation of the residuals
};

/// Linear fit y = X c with bisquare weights (GSL multifit_robust).
/// @throws ConvergenceError
[[nodiscard]] RobustLinearFit fit_linear_robust(const Eigen::MatrixXd& design,
                                                const Eigen::VectorXd& observations);

}  // namespace ashimpact::gsl
