// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/robust.hpp"

#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>

#include "solver/numeric/gsl/status.hpp"
#include "solver/numeric/gsl/views.hpp"

namespace ashimpact::gsl {

namespace {

using Workspace = std::unique_ptr<gsl_multifit_robust_workspace, decltype(&gsl_multifit_robust_free)>;

Workspace workspace_for(Eigen::Index rows, Eigen::Index columns) {
    quiet();
    Workspace workspace(
        gsl_multifit_robust_alloc(gsl_multifit_robust_bisquare, static_cast<std::size_t>(rows),
                                  static_cast<std::size_t>(columns)),
        &gsl_multifit_robust_free);
    if (!workspace) check(GSL_EINVAL, "robust fit");
    return workspace;
}

}  // namespace

Eigen::VectorXd bisquare_weights(const Eigen::VectorXd& residuals, int parameters) {
    const Workspace workspace = workspace_for(residuals.size(), parameters);
    Eigen::VectorXd weights(residuals.size());
    const auto size = static_cast<std::size_t>(residuals.size());
    const auto from = gsl_vector_const_view_array(residuals.data(), size);
    auto to = gsl_vector_view_array(weights.data(), size);
    check(gsl_multifit_robust_weights(&from.vector, &to.vector, workspace.get()), "robust weights");
    return weights;
}

RobustLinearFit fit_linear_robust(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations) {
    const Workspace workspace = workspace_for(design.rows(), design.cols());
    const auto rows = static_cast<std::size_t>(design.rows());
    const auto columns = static_cast<std::size_t>(design.cols());
    const RowMajor x = design;
    RowMajor covariance(design.cols(), design.cols());
    RobustLinearFit fit{Eigen::VectorXd(design.cols()), {}, {}, 0.0};
    const auto x_view = gsl_matrix_const_view_array(x.data(), rows, columns);
    const auto y_view = gsl_vector_const_view_array(observations.data(), rows);
    auto c_view = gsl_vector_view_array(fit.parameters.data(), columns);
    auto covariance_view = gsl_matrix_view_array(covariance.data(), columns, columns);
    check(gsl_multifit_robust(&x_view.matrix, &y_view.vector, &c_view.vector, &covariance_view.matrix,
                              workspace.get()),
          "robust fit");
    fit.covariance = covariance;
    fit.residuals = observations - design * fit.parameters;
    fit.deviation = gsl_multifit_robust_statistics(workspace.get()).sigma;
    return fit;
}

}  // namespace ashimpact::gsl
