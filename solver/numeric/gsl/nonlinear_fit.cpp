// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/nonlinear_fit.hpp"

#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/guard.hpp"
#include "solver/numeric/gsl/status.hpp"
#include "solver/numeric/gsl/views.hpp"

namespace ashimpact::gsl {

namespace {

using FitTarget = Guarded<NonlinearProblem>;

/// Runs @p action for GSL. Returns a GSL status.
template <class Action>
int status_of(FitTarget& target, Action&& action) {
    const auto done = [&] {
        action();
        return static_cast<int>(GSL_SUCCESS);
    };
    return target.value_of(done, GSL_EFAILED);
}

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

int evaluate(const gsl_vector* x, void* parameters, gsl_vector* f) {
    auto& target = *static_cast<FitTarget*>(parameters);
    return status_of(target, [&] { view_of(f) = target.function.residuals(view_of(x)); });
}

int differentiate(const gsl_vector* x, void* parameters, gsl_matrix* jacobian) {
    auto& target = *static_cast<FitTarget*>(parameters);
    return status_of(target, [&] { view_of(jacobian) = target.function.jacobian(view_of(x)); });
}

Eigen::MatrixXd covariance_of(const gsl_multifit_nlinear_workspace* workspace, std::size_t size) {
    RowMajor covariance(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
    auto view = gsl_matrix_view_array(covariance.data(), size, size);
    check(gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace), 0.0, &view.matrix), "covariance");
    return covariance;
}

}  // namespace

NonlinearFit fit_nonlinear(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
                           const Eigen::VectorXd& start, const NonlinearFitOptions& options) {
    return fit_nonlinear(NonlinearProblem{.residuals = residuals}, start, options);
}

NonlinearFit fit_nonlinear(const NonlinearProblem& fitted, const Eigen::VectorXd& start,
                           const NonlinearFitOptions& options) {
    quiet();
    const auto count = static_cast<std::size_t>(fitted.residuals(start).size());
    const auto size = static_cast<std::size_t>(start.size());
    gsl_multifit_nlinear_parameters setup = gsl_multifit_nlinear_default_parameters();
    setup.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
    setup.h_df = options.difference_step;
    const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> workspace(
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &setup, count, size),
        &gsl_multifit_nlinear_free);

    FitTarget target{fitted};
    gsl_multifit_nlinear_fdf problem{};
    problem.f = &evaluate;
    if (fitted.jacobian) problem.df = &differentiate;
    problem.n = count;
    problem.p = size;
    problem.params = &target;
    const auto start_view = gsl_vector_const_view_array(start.data(), size);
    int info = 0;
    int status = gsl_multifit_nlinear_init(&start_view.vector, &problem, workspace.get());
    if (status == GSL_SUCCESS) {
        status = gsl_multifit_nlinear_driver(static_cast<std::size_t>(options.most_iterations),
                                             options.parameter_tolerance, options.gradient_tolerance, 0.0,
                                             nullptr, nullptr, &info, workspace.get());
    }
    target.rethrow();
    // How GSL stopped does not decide: rounding can keep its tests from passing at the minimum, and residuals
    // that are not smooth can pass them elsewhere.
    if (status != GSL_ENOPROG && status != GSL_EMAXITER) check(status, "nonlinear fit");
    const bool stationary = is_stationary(workspace.get());
    if (!stationary && options.smooth) {
        throw ConvergenceError("nonlinear fit: no further progress where chi^2 is not at its minimum");
    }

    NonlinearFit fit;
    fit.parameters = view_of(gsl_multifit_nlinear_position(workspace.get()));
    fit.residuals = view_of(gsl_multifit_nlinear_residual(workspace.get()));
    fit.covariance = covariance_of(workspace.get(), size);
    fit.chi_squared = fit.residuals.squaredNorm();
    fit.stationary = stationary;
    fit.iterations = static_cast<int>(gsl_multifit_nlinear_niter(workspace.get()));
    return fit;
}

}  // namespace ashimpact::gsl
