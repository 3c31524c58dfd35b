// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Dense>

namespace ashimpact::gsl {

/// How close a root is to be bracketed.
struct RootOptions {
    double relative = 1e-13;
    double absolute = 0.0;
    int most_iterations = 200;
};

struct RootSummary {
    double root;
    int iterations;
};

/// The root of @p function in [lower, upper], whose ends must differ in sign, by Brent's method.
/// @throws ConvergenceError
[[nodiscard]] RootSummary brent(const std::function<double(double)>& function, double lower, double upper,
                                const RootOptions& options = {});

/// Position of a minimum of @p function in [lower, upper] by Brent's method (GSL min).
/// @param guess between the ends; returned unchanged unless the function is less there than at both ends
/// @throws whatever the function throws
[[nodiscard]] double minimise_between(const std::function<double(double)>& function, double lower,
                                      double guess, double upper, double relative = 1e-4);

/// Position of a minimum of a function of several numbers, which may have kinks, by the simplex of Nelder and
/// Mead (GSL multimin, nmsimplex2), restarted until a restart gains less than 1e-9 of the value.
/// @param steps first sizes of the simplex, not zero
/// @throws whatever the function throws
[[nodiscard]] Eigen::VectorXd minimise(const std::function<double(const Eigen::VectorXd&)>& function,
                                       const Eigen::VectorXd& start, const Eigen::VectorXd& steps);

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

}  // namespace ashimpact::gsl
