// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/bspline.hpp"

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>

#include "solver/numeric/gsl/status.hpp"
#include "solver/numeric/gsl/views.hpp"

namespace ashimpact::gsl {

namespace {

constexpr std::size_t order = 4;  ///< cubic

}  // namespace

struct BSpline::Workspace {
    std::unique_ptr<gsl_bspline_workspace, decltype(&gsl_bspline_free)> state;
    std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)> derivatives;

    explicit Workspace(std::size_t breaks)
        : state(gsl_bspline_alloc(order, breaks), &gsl_bspline_free), derivatives(nullptr, &gsl_matrix_free) {
        if (!state) check(GSL_EINVAL, "B-spline");
        derivatives.reset(gsl_matrix_alloc(gsl_bspline_ncoeffs(state.get()), 2));
    }
    [[nodiscard]] Eigen::VectorXd column(double x, Eigen::Index derivative) const {
        check(gsl_bspline_deriv_eval(x, 1, derivatives.get(), state.get()), "B-spline");
        return view_of(derivatives.get()).col(derivative);
    }
};

BSpline::BSpline(std::span<const double> breaks) {
    quiet();
    workspace_ = std::make_unique<Workspace>(breaks.size());
    const auto view = gsl_vector_const_view_array(breaks.data(), breaks.size());
    check(gsl_bspline_knots(&view.vector, workspace_->state.get()), "B-spline");
}

BSpline::~BSpline() = default;
BSpline::BSpline(BSpline&&) noexcept = default;
BSpline& BSpline::operator=(BSpline&&) noexcept = default;

Eigen::Index BSpline::size() const {
    return static_cast<Eigen::Index>(gsl_bspline_ncoeffs(workspace_->state.get()));
}

Eigen::VectorXd BSpline::values(double x) const {
    return workspace_->column(x, 0);
}

Eigen::VectorXd BSpline::slopes(double x) const {
    return workspace_->column(x, 1);
}

}  // namespace ashimpact::gsl
