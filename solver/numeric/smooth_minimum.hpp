#pragma once

#include <Eigen/Dense>

#include <functional>

namespace ashimpact {

/// A smooth function with its gradient; infinite where it is not defined.
struct SmoothFunction {
    struct Value {
        double value;
        Eigen::VectorXd gradient;
    };
    std::function<Value(const Eigen::VectorXd&)> evaluate;
};

struct SmoothMinimumOptions {
    double first_step = 1.0;  ///< length of the longest first step
    /// A minimum is found where the model of the function says that no step lowers it by more than this.
    double tolerance = 1e-8;
    /// Also converged if rounding stops the search with at most this decrease predicted.
    double acceptable = 1e-3;
    int most_evaluations = 100;
};

struct SmoothMinimum {
    Eigen::VectorXd place;
    double value;
    Eigen::MatrixXd curvature;  ///< as learnt on the way
    int evaluations;
    bool converged;
};

/// Minimum by a quasi-Newton method with a trust region and the symmetric rank-one update (Conn, Gould &
/// Toint 2000, ch. 8.4). Rejects steps into undefined regions and learns from failed ones. The variables should be of a size
/// at which the curvature is near one.
/// @throws ConvergenceError where the function is not defined at the start; whatever the function throws
[[nodiscard]] SmoothMinimum minimise(const SmoothFunction& function, const Eigen::VectorXd& start,
                                     const SmoothMinimumOptions& options = {});

}  // namespace ashimpact
