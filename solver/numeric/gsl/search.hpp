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

}  // namespace ashimpact::gsl
