// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Dense>

namespace ashimpact::gsl {

struct NonlinearFitOptions {
    double parameter_tolerance = 1e-10;  ///< relative step at which a fit has converged
    double gradient_tolerance = 1e-12;
    double difference_step = 1e-6;  ///< relative step of the finite-difference Jacobian
    int most_iterations = 200;
    bool smooth = true;  ///< false: residuals may have kinks, at which a fit may stall
};

struct NonlinearFit {
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;  ///< (J^T J)^-1 at the solution
    Eigen::VectorXd residuals;
    double chi_squared;
    int iterations;
    bool stationary;  ///< false: stalled at a kink; only where the residuals need not be smooth
};

/// Residuals as a function of the parameters, and their derivatives where those are known.
struct NonlinearProblem {
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residuals;
    std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian{};  ///< empty: central differences
};

/// Minimises the sum of squares of the residuals by Levenberg-Marquardt with geodesic acceleration off (GSL
/// multifit_nlinear).
/// @throws ConvergenceError; whatever the functions throw
[[nodiscard]] NonlinearFit fit_nonlinear(const NonlinearProblem& fitted, const Eigen::VectorXd& start,
                                         const NonlinearFitOptions& options = {});

/// The same with central differences.
[[nodiscard]] NonlinearFit fit_nonlinear(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals, const Eigen::VectorXd& start,
    const NonlinearFitOptions& options = {});

}  // namespace ashimpact::gsl
