// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/spline.hpp"

#include <gsl/gsl_spline.h>

#include "solver/numeric/gsl/status.hpp"

namespace ashimpact::gsl {

struct MonotoneSpline::Handle {
    std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> state;
};

MonotoneSpline::MonotoneSpline(std::span<const double> x, std::span<const double> y) {
    quiet();
    Handle handle{{gsl_spline_alloc(gsl_interp_steffen, x.size()), &gsl_spline_free}};
    check(gsl_spline_init(handle.state.get(), x.data(), y.data(), x.size()), "interpolation");
    handle_ = std::make_shared<const Handle>(std::move(handle));
}

double MonotoneSpline::operator()(double x) const {
    double y = 0.0;
    check(gsl_spline_eval_e(handle_->state.get(), x, nullptr, &y), "interpolation");
    return y;
}

double MonotoneSpline::lower() const {
    return handle_->state->x[0];
}
double MonotoneSpline::upper() const {
    return handle_->state->x[handle_->state->size - 1];
}

}  // namespace ashimpact::gsl
