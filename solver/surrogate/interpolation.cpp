// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/interpolation.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"

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

gsl::MonotoneSpline spline_through(std::span<const double> x, std::span<const double> y) {
    require_curve(x, y);
    return {x, y};
}

}  // namespace

MeasuredCurve::MeasuredCurve(std::span<const double> x, std::span<const double> y)
    : spline_(spline_through(x, y)) {}

double MeasuredCurve::operator()(double x) const {
    if (!(x >= lower() && x <= upper())) {
        throw InputError("a measured curve is asked for its value at " + std::to_string(x),
                         std::to_string(lower()) + " to " + std::to_string(upper()) + ", the measured range");
    }
    return spline_(x);
}

}  // namespace ashimpact
