// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/damping_fit.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/fit.hpp"

namespace ashimpact {

namespace {

constexpr int coefficient_count = 3;

void require_usable(std::span<const DampingPoint> points) {
    std::set<double> distinct;
    std::size_t weighted = 0;
    for (const DampingPoint& point : points) {
        if (!std::isfinite(point.restitution) || !std::isfinite(point.damping) ||
            !(point.standard_uncertainty >= 0.0) || !std::isfinite(point.standard_uncertainty)) {
            throw InputError("a point of the damping fit is not finite or has a negative uncertainty",
                             "finite numbers");
        }
        distinct.insert(point.restitution);
        weighted += point.standard_uncertainty > 0.0 ? 1 : 0;
    }
    if (distinct.size() < coefficient_count) {
        throw InputError("the damping fit has " + std::to_string(distinct.size()) + " distinct restitutions",
                         "at least 3 for a quadratic");
    }
    if (weighted != 0 && weighted != points.size()) {
        throw InputError("only some points of the damping fit have an uncertainty", "all of them or none");
    }
}

}  // namespace

DampingFit fit_damping(std::span<const DampingPoint> points) {
    require_usable(points);
    const auto count = static_cast<Eigen::Index>(points.size());
    const bool weighted = points.front().standard_uncertainty > 0.0;
    Eigen::MatrixXd design(count, coefficient_count);
    Eigen::VectorXd observations(count);
    Eigen::VectorXd weights(weighted ? count : 0);
    for (Eigen::Index i = 0; i < count; ++i) {
        const DampingPoint& point = points[static_cast<std::size_t>(i)];
        design.row(i) << point.restitution * point.restitution, point.restitution, 1.0;
        observations[i] = point.damping;
        if (weighted) weights[i] = 1.0 / (point.standard_uncertainty * point.standard_uncertainty);
    }
    const gsl::LinearFit linear = gsl::fit_linear(design, observations, weights);

    DampingFit fit{};
    fit.damping.coefficients = linear.parameters.reverse();
    fit.chi_squared = linear.chi_squared;
    fit.degrees_of_freedom = static_cast<int>(count) - coefficient_count;
    const double freedom = std::max(1, fit.degrees_of_freedom);
    fit.residual_deviation = (observations - design * linear.parameters).norm() / std::sqrt(freedom);
    const double scatter = weighted ? 1.0 : linear.chi_squared / freedom;
    fit.covariance = scatter * linear.covariance.reverse();
    return fit;
}

}  // namespace ashimpact
