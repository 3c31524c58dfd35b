#pragma once

#include <Eigen/Dense>

#include <functional>

namespace ashimpact::gsl {

/// A smooth function with its gradient; infinite where it is not defined.
struct SmoothFunction {
    struct Value {
        double value;
        Eigen::VectorXd gradient;
    };
    std::function<Value(const Eigen::VectorXd&)> evaluate;
};

struct MinimumOptions {
    double gradient_tolerance = 1e-4;  ///< length of the gradient at which a minimum is found
    /// Length at which it has been found, too, where the search cannot go on for want of digits: the function
    /// is then within half its square of the minimum.
    double acceptable_gradient = 0.03;
    double first_step = 0.1;
    int most_iterations = 100;
};

struct Minimum {
    Eigen::VectorXd place;
    double value;
    int iterations;
    bool converged;
};

/// Minimum by BFGS (GSL multimin). The variables should be of a size at which the curvature is near one.
/// @throws ConvergenceError where the function is not defined at the start; whatever the function throws
[[nodiscard]] Minimum minimise(const SmoothFunction& function, const Eigen::VectorXd& start,
                               const MinimumOptions& options = {});

/// Position of a minimum of @p function in [lower, upper] by Brent's method (GSL min).
/// @param guess between the ends; returned as it is where the function is not less there than at both ends
/// @throws whatever the function throws
[[nodiscard]] double minimise_between(const std::function<double(double)>& function, double lower,
                                      double guess, double upper, double relative = 1e-4);

}  // namespace ashimpact::gsl
