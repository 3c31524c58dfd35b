// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/interpolation.hpp"

#include <cmath>
#include <mutex>
#include <string>

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_spline.h>

#include "solver/numeric/gsl/support.hpp"

namespace ashimpact::gsl {

struct BSpline::Workspace {
    Owner<gsl_bspline_workspace> state;
    Owner<gsl_matrix> derivatives;
    std::mutex in_use;  ///< evaluation writes to the workspace

    explicit Workspace(std::size_t breaks)
        : state(gsl_bspline_alloc(4, breaks), &gsl_bspline_free), derivatives(nullptr, &gsl_matrix_free) {
        if (!state) check(GSL_EINVAL, "B-spline");
        derivatives.reset(gsl_matrix_alloc(gsl_bspline_ncoeffs(state.get()), 2));
    }
};

BSpline::BSpline(std::span<const double> breaks)
    : workspace_(nullptr, [](Workspace* workspace) { delete workspace; }) {
    quiet();
    workspace_.reset(new Workspace(breaks.size()));
    const auto view = gsl_vector_const_view_array(breaks.data(), breaks.size());
    check(gsl_bspline_knots(&view.vector, workspace_->state.get()), "B-spline");
}

Eigen::Index BSpline::size() const {
    return index_of(gsl_bspline_ncoeffs(workspace_->state.get()));
}

Eigen::VectorXd BSpline::values(double x, int derivative) const {
    const std::lock_guard lock(workspace_->in_use);
    gsl_matrix* derivatives = workspace_->derivatives.get();
    check(gsl_bspline_deriv_eval(x, 1, derivatives, workspace_->state.get()), "B-spline");
    return view_of(derivatives).col(derivative);
}

std::vector<QuadratureNode> gauss_legendre(int count, double lower, double upper) {
    quiet();
    std::vector<QuadratureNode> nodes(static_cast<std::size_t>(count));
    const Owner<gsl_integration_glfixed_table> table(gsl_integration_glfixed_table_alloc(nodes.size()),
                                                     &gsl_integration_glfixed_table_free);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        check(
            gsl_integration_glfixed_point(lower, upper, i, &nodes[i].position, &nodes[i].weight, table.get()),
            "quadrature");
    return nodes;
}

}  // namespace ashimpact::gsl

namespace ashimpact {

namespace {

void require_curve(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size() || x.size() < 3)
        throw InputError("a measured curve has " + std::to_string(x.size()) + " abscissae and " +
                             std::to_string(y.size()) + " values",
                         "as many of both, at least 3");
    for (std::size_t i = 0; i < x.size(); ++i) {
        const bool ordered = i == 0 || x[i] > x[i - 1];
        if (!ordered || !std::isfinite(x[i]) || !std::isfinite(y[i]))
            throw InputError(
                "point " + std::to_string(i + 1) + " of a measured curve is out of order or not finite",
                "finite values, abscissae strictly increasing");
    }
}

}  // namespace

struct MeasuredCurve::Spline {
    gsl::Owner<gsl_spline> state;
};

MeasuredCurve::MeasuredCurve(std::span<const double> x, std::span<const double> y) {
    require_curve(x, y);
    gsl::quiet();
    Spline spline{{gsl_spline_alloc(gsl_interp_steffen, x.size()), &gsl_spline_free}};
    gsl::check(gsl_spline_init(spline.state.get(), x.data(), y.data(), x.size()), "interpolation");
    spline_ = std::make_shared<const Spline>(std::move(spline));
}

double MeasuredCurve::operator()(double x) const {
    if (!(x >= lower() && x <= upper()))
        throw InputError("a measured curve is asked for its value at " + std::to_string(x),
                         std::to_string(lower()) + " to " + std::to_string(upper()) + ", the measured range");
    double y = 0.0;
    gsl::check(gsl_spline_eval_e(spline_->state.get(), x, nullptr, &y), "interpolation");
    return y;
}

double MeasuredCurve::lower() const {
    return spline_->state->x[0];
}

double MeasuredCurve::upper() const {
    return spline_->state->x[spline_->state->size - 1];
}

}  // namespace ashimpact
