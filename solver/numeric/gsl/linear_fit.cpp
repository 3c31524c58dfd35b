// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/linear_fit.hpp"

#include <memory>

#include <gsl/gsl_multifit.h>

#include "solver/numeric/gsl/status.hpp"
#include "solver/numeric/gsl/views.hpp"

namespace ashimpact::gsl {

LinearFit fit_linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observations,
                     const Eigen::VectorXd& weights) {
    quiet();
    const auto rows = static_cast<std::size_t>(design.rows());
    const auto columns = static_cast<std::size_t>(design.cols());
    const RowMajor x = design;
    RowMajor covariance(design.cols(), design.cols());
    LinearFit fit{Eigen::VectorXd(design.cols()), {}, 0.0};
    const auto x_view = gsl_matrix_const_view_array(x.data(), rows, columns);
    const auto y_view = gsl_vector_const_view_array(observations.data(), rows);
    auto c_view = gsl_vector_view_array(fit.parameters.data(), columns);
    auto covariance_view = gsl_matrix_view_array(covariance.data(), columns, columns);
    const std::unique_ptr<gsl_multifit_linear_workspace, decltype(&gsl_multifit_linear_free)> workspace(
        gsl_multifit_linear_alloc(rows, columns), &gsl_multifit_linear_free);
    const Eigen::VectorXd weight = weights.size() > 0 ? weights : Eigen::VectorXd::Ones(design.rows());
    const auto w_view = gsl_vector_const_view_array(weight.data(), rows);
    check(gsl_multifit_wlinear(&x_view.matrix, &w_view.vector, &y_view.vector, &c_view.vector,
                               &covariance_view.matrix, &fit.chi_squared, workspace.get()),
          "linear fit");
    fit.covariance = covariance;
    return fit;
}

}  // namespace ashimpact::gsl
