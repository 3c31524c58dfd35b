// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/spline.hpp"

#include <cmath>
#include <string>

#include <gsl/gsl_spline.h>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/status.hpp"

namespace ashimpact {

namespace {

void require_curve(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size() || x.size() < 3) {
        throw InputError("a measured curve has " + std::to_string(x.size()) + " abscissae and " +
                             std::to_string(y.size()) + " values",
                         "as many of both, at least 3");
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const bool ordered = i == 0 || x[i] > x[i - 1];
        if (!ordered || !std::isfinite(x[i]) || !std::isfinite(y[i])) {
            throw InputError(
                "point " + std::to_string(i + 1) + " of a measured curve is out of order or not finite",
                "finite values, abscissae strictly increasing");
        }
    }
}

}  // namespace

struct MeasuredCurve::Spline {
    std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> state;
};

MeasuredCurve::MeasuredCurve(std::span<const double> x, std::span<const double> y) {
    require_curve(x, y);
    gsl::quiet();
    Spline spline{{gsl_spline_alloc(gsl_interp_steffen, x.size()), &gsl_spline_free}};
    gsl::check(gsl_spline_init(spline.state.get(), x.data(), y.data(), x.size()), "interpolation");
    spline_ = std::make_shared<const Spline>(std::move(spline));
}

double MeasuredCurve::operator()(double x) const {
    if (!(x >= lower() && x <= upper())) {
        throw InputError("a measured curve is asked for its value at " + std::to_string(x),
                         std::to_string(lower()) + " to " + std::to_string(upper()) + ", the measured range");
    }
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
