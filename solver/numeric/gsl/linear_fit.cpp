// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/linear_fit.hpp"

#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>

#include "solver/numeric/gsl/status.hpp"
#include "solver/numeric/gsl/views.hpp"

namespace ashimpact::gsl {

namespace {

using RobustWorkspace = std::unique_ptr<gsl_multifit_robust_workspace, decltype(&gsl_multifit_robust_free)>;

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

}  // namespace

LinearFit fit_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations,
                     const Eigen::VectorXd& weights) {
    quiet();
    const std::unique_ptr<gsl_multifit_linear_workspace, decltype(&gsl_multifit_linear_free)> workspace(
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

}  // namespace ashimpact::gsl
