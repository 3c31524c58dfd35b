// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/fit.hpp"

#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include "solver/numeric/gsl/support.hpp"

namespace ashimpact::gsl {

namespace {

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
    if (!stationary && options.smooth)
        throw ConvergenceError("nonlinear fit: no further progress where chi^2 is not at its minimum");

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
