// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/solvers.hpp"

#include <cmath>

#include <gsl/gsl_min.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_roots.h>

#include "solver/numeric/gsl/support.hpp"

namespace ashimpact::gsl {

namespace {

constexpr double no_value = 1e12;  ///< in place of infinity, which GSL's line search does not accept

/// The value of a guarded function for GSL.
template <class Function, class Argument>
double finite_value(void* guarded, const Argument& x) {
    auto& target = *static_cast<Guarded<Function>*>(guarded);
    const double value = target.value_of([&] { return target.function(x); }, no_value);
    return std::isfinite(value) ? value : no_value;
}

using OfOne = std::function<double(double)>;
using OfSeveral = std::function<double(const Eigen::VectorXd&)>;

/// One simplex from @p position until it has shrunk to a millionth of @p steps. Returns the value there.
double shrink_simplex(const OfSeveral& function, Eigen::VectorXd& position, const Eigen::VectorXd& steps) {
    const auto size = static_cast<std::size_t>(position.size());
    const Owner<gsl_multimin_fminimizer> minimiser(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, size),
        &gsl_multimin_fminimizer_free);
    // In units of the steps, so that the size of the simplex means the same in every direction.
    const Eigen::VectorXd scaled = position.cwiseQuotient(steps);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(position.size());
    const OfSeveral in_steps = [&](const Eigen::VectorXd& x) { return function(x.cwiseProduct(steps)); };
    Guarded<OfSeveral> target{in_steps};
    gsl_multimin_function problem{
        [](const gsl_vector* x, void* self) { return finite_value<OfSeveral>(self, view_of(x)); }, size,
        &target};
    const auto start = gsl_vector_const_view_array(scaled.data(), size);
    const auto sides = gsl_vector_const_view_array(ones.data(), size);
    int status = gsl_multimin_fminimizer_set(minimiser.get(), &problem, &start.vector, &sides.vector);
    for (int i = 0; i < 2000 && status == GSL_SUCCESS && !target.error; ++i) {
        status = gsl_multimin_fminimizer_iterate(minimiser.get());
        if (gsl_multimin_fminimizer_size(minimiser.get()) < 1e-6) break;
    }
    target.rethrow();
    position = Eigen::VectorXd(view_of(gsl_multimin_fminimizer_x(minimiser.get()))).cwiseProduct(steps);
    return gsl_multimin_fminimizer_minimum(minimiser.get());
}

using RobustWorkspace = Owner<gsl_multifit_robust_workspace>;

RobustWorkspace robust_workspace(std::size_t rows, std::size_t columns) {
    quiet();
    RobustWorkspace workspace(gsl_multifit_robust_alloc(gsl_multifit_robust_bisquare, rows, columns),
                              &gsl_multifit_robust_free);
    if (!workspace) check(GSL_EINVAL, "robust fit");
    return workspace;
}

gsl_vector_const_view view_in_place(const Eigen::VectorXd& vector) {
    return gsl_vector_const_view_array(vector.data(), static_cast<std::size_t>(vector.size()));
}

/// Parameters and covariance as @p solve(X, c, covariance) fills them in.
template <class Solve>
LinearFit solved(const Eigen::MatrixXd& design, Solve&& solve) {
    const RowMajor x = design;
    RowMajor covariance(design.cols(), design.cols());
    LinearFit fit{Eigen::VectorXd(design.cols()), {}};
    const auto columns = static_cast<std::size_t>(design.cols());
    const auto x_view =
        gsl_matrix_const_view_array(x.data(), static_cast<std::size_t>(design.rows()), columns);
    auto c_view = gsl_vector_view_array(fit.parameters.data(), columns);
    auto covariance_view = gsl_matrix_view_array(covariance.data(), columns, columns);
    solve(fit, &x_view.matrix, &c_view.vector, &covariance_view.matrix);
    fit.covariance = covariance;
    return fit;
}

using FitTarget = Guarded<NonlinearProblem>;

/// Whether no step can lower chi^2 by more than rounding: the best linear one gains less than 1e-8 of it, or
/// changes no parameter by more than 1e-6 of itself.
bool is_stationary(const gsl_multifit_nlinear_workspace* workspace) {
    const auto jacobian = view_of(gsl_multifit_nlinear_jac(workspace));
    const Eigen::VectorXd residuals = view_of(gsl_multifit_nlinear_residual(workspace));
    const Eigen::VectorXd parameters = view_of(gsl_multifit_nlinear_position(workspace));
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(jacobian.rows(), jacobian.cols());
    factors.setThreshold(1e-6);  // directions below the noise of the differences do not count
    const Eigen::VectorXd step = factors.compute(jacobian).solve(residuals);
    const double gain = (jacobian * step).squaredNorm();
    return gain <= 1e-8 * residuals.squaredNorm() ||
           (step.array().abs() <= 1e-6 * parameters.array().abs()).all();
}

/// Refines a minimum by Gauss-Newton steps. The trust region stops where chi^2 changes by less than rounding;
/// the gradient still resolves the minimum there.
Eigen::VectorXd polished(const NonlinearProblem& fitted, Eigen::VectorXd parameters) {
    constexpr double least = 1e-11;  // of the parameters
    constexpr int most_steps = 4;
    double last = 1e-6;  // longer steps are not due to rounding
    for (int i = 0; i < most_steps; ++i) {
        const Eigen::MatrixXd jacobian = fitted.jacobian(parameters);
        const Eigen::VectorXd step = jacobian.colPivHouseholderQr().solve(fitted.residuals(parameters));
        const double length = step.norm() / parameters.norm();
        if (!(length < last)) break;
        parameters -= step;
        last = length;
        if (length < least) break;
    }
    return parameters;
}

/// Stores what @p member of the problem gives at @p x, for GSL. Returns a GSL status.
template <class Member, class Result>
int evaluate(const gsl_vector* x, void* parameters, Member member, Result* result) {
    auto& target = *static_cast<FitTarget*>(parameters);
    const auto done = [&] {
        view_of(result) = (target.function.*member)(view_of(x));
        return static_cast<int>(GSL_SUCCESS);
    };
    return target.value_of(done, GSL_EFAILED);
}

Eigen::MatrixXd covariance_of(const gsl_multifit_nlinear_workspace* workspace, std::size_t size) {
    RowMajor covariance(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
    auto view = gsl_matrix_view_array(covariance.data(), size, size);
    check(gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace), 0.0, &view.matrix), "covariance");
    return covariance;
}

}  // namespace

RootSummary brent(const std::function<double(double)>& function, double lower, double upper,
                  const RootOptions& options) {
    quiet();
    using Target = Guarded<std::function<double(double)>>;
    Target guarded{function};
    gsl_function target{[](double x, void* self) {
                            auto& to = *static_cast<Target*>(self);
                            return to.value_of([&] { return to.function(x); }, 0.0);
                        },
                        &guarded};
    const Owner<gsl_root_fsolver> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                         &gsl_root_fsolver_free);
    const int status = gsl_root_fsolver_set(solver.get(), &target, lower, upper);
    guarded.rethrow();
    check(status, "root finding");
    for (int i = 1; i <= options.most_iterations; ++i) {
        const int iterated = gsl_root_fsolver_iterate(solver.get());
        guarded.rethrow();
        check(iterated, "root finding");
        const double a = gsl_root_fsolver_x_lower(solver.get());
        const double b = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(a, b, options.absolute, options.relative) == GSL_SUCCESS)
            return {gsl_root_fsolver_root(solver.get()), i};
    }
    throw ConvergenceError("root finding: iteration limit reached");
}

double minimise_between(const std::function<double(double)>& function, double lower, double guess,
                        double upper, double relative) {
    quiet();
    Guarded<OfOne> guarded{function};
    gsl_function target{[](double x, void* self) { return finite_value<OfOne>(self, x); }, &guarded};
    const Owner<gsl_min_fminimizer> minimiser(gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent),
                                              &gsl_min_fminimizer_free);
    double position = guess;
    int status = gsl_min_fminimizer_set(minimiser.get(), &target, guess, lower, upper);
    for (int i = 0; i < 100 && status == GSL_SUCCESS && !guarded.error; ++i) {
        status = gsl_min_fminimizer_iterate(minimiser.get());
        position = gsl_min_fminimizer_x_minimum(minimiser.get());
        const double a = gsl_min_fminimizer_x_lower(minimiser.get());
        const double b = gsl_min_fminimizer_x_upper(minimiser.get());
        if (b - a <= relative * (upper - lower)) break;
    }
    guarded.rethrow();
    return position;
}

Eigen::VectorXd minimise(const std::function<double(const Eigen::VectorXd&)>& function,
                         const Eigen::VectorXd& start, const Eigen::VectorXd& steps) {
    quiet();
    Eigen::VectorXd position = start;
    double least = function(start);
    constexpr int most_restarts = 20;
    for (int i = 0; i < most_restarts; ++i) {
        const double value = shrink_simplex(function, position, steps);
        const bool converged = least - value <= 1e-9 * std::abs(value);
        least = value;
        if (converged) break;
    }
    return position;
}

LinearFit fit_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations,
                     const Eigen::VectorXd& weights) {
    quiet();
    const Owner<gsl_multifit_linear_workspace> workspace(
        gsl_multifit_linear_alloc(static_cast<std::size_t>(design.rows()),
                                  static_cast<std::size_t>(design.cols())),
        &gsl_multifit_linear_free);
    const Eigen::VectorXd weight = weights.size() > 0 ? weights : Eigen::VectorXd::Ones(design.rows());
    const auto w = view_in_place(weight);
    const auto y = view_in_place(observations);
    return solved(design, [&](LinearFit& fit, const gsl_matrix* x, gsl_vector* c, gsl_matrix* covariance) {
        check(gsl_multifit_wlinear(x, &w.vector, &y.vector, c, covariance, &fit.chi_squared, workspace.get()),
              "linear fit");
    });
}

LinearFit fit_linear_robust(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations) {
    const RobustWorkspace workspace =
        robust_workspace(static_cast<std::size_t>(design.rows()), static_cast<std::size_t>(design.cols()));
    const auto y = view_in_place(observations);
    return solved(design, [&](LinearFit& fit, const gsl_matrix* x, gsl_vector* c, gsl_matrix* covariance) {
        check(gsl_multifit_robust(x, &y.vector, c, covariance, workspace.get()), "robust fit");
        fit.deviation = gsl_multifit_robust_statistics(workspace.get()).sigma;
    });
}

Eigen::VectorXd bisquare_weights(const Eigen::VectorXd& residuals, int parameters) {
    const auto size = static_cast<std::size_t>(residuals.size());
    const RobustWorkspace workspace = robust_workspace(size, static_cast<std::size_t>(parameters));
    Eigen::VectorXd weights(residuals.size());
    const auto from = view_in_place(residuals);
    auto to = gsl_vector_view_array(weights.data(), size);
    check(gsl_multifit_robust_weights(&from.vector, &to.vector, workspace.get()), "robust weights");
    return weights;
}

NonlinearFit fit_nonlinear(const NonlinearProblem& fitted, const Eigen::VectorXd& start,
                           const NonlinearFitOptions& options) {
    quiet();
    const auto count = static_cast<std::size_t>(fitted.residuals(start).size());
    const auto size = static_cast<std::size_t>(start.size());
    gsl_multifit_nlinear_parameters setup = gsl_multifit_nlinear_default_parameters();
    setup.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
    setup.h_df = options.difference_step;
    const Owner<gsl_multifit_nlinear_workspace> workspace(
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &setup, count, size),
        &gsl_multifit_nlinear_free);

    FitTarget target{fitted};
    gsl_multifit_nlinear_fdf problem{};
    problem.f = [](const gsl_vector* x, void* self, gsl_vector* f) {
        return evaluate(x, self, &NonlinearProblem::residuals, f);
    };
    if (fitted.jacobian)
        problem.df = [](const gsl_vector* x, void* self, gsl_matrix* jacobian) {
            return evaluate(x, self, &NonlinearProblem::jacobian, jacobian);
        };
    problem.n = count;
    problem.p = size;
    problem.params = &target;
    const auto start_view = gsl_vector_const_view_array(start.data(), size);
    int info = 0;
    int status = gsl_multifit_nlinear_init(&start_view.vector, &problem, workspace.get());
    if (status == GSL_SUCCESS)
        status = gsl_multifit_nlinear_driver(static_cast<std::size_t>(options.most_iterations),
                                             options.parameter_tolerance, options.gradient_tolerance, 0.0,
                                             nullptr, nullptr, &info, workspace.get());
    target.rethrow();
    // How GSL stopped does not decide: rounding can keep its tests from passing at the minimum, and residuals
    // that are not smooth can pass them elsewhere.
    if (status != GSL_ENOPROG && status != GSL_EMAXITER) check(status, "nonlinear fit");
    const bool stationary = is_stationary(workspace.get());
    if (!stationary && options.smooth)
        throw ConvergenceError("nonlinear fit: no further progress where chi^2 is not at its minimum");

    NonlinearFit fit;
    fit.parameters = view_of(gsl_multifit_nlinear_position(workspace.get()));
    if (stationary && fitted.jacobian) fit.parameters = polished(fitted, fit.parameters);
    fit.residuals = view_of(gsl_multifit_nlinear_residual(workspace.get()));
    fit.covariance = covariance_of(workspace.get(), size);
    fit.chi_squared = fit.residuals.squaredNorm();
    fit.stationary = stationary;
    fit.iterations = static_cast<int>(gsl_multifit_nlinear_niter(workspace.get()));
    return fit;
}

}  // namespace ashimpact::gsl
