// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/curve_posterior.hpp"

#include <algorithm>
#include <cmath>

#include "solver/batch/parallel.hpp"

namespace ashimpact {

namespace {

constexpr double outlier_share = 0.02;
constexpr double slope_mean = -0.4;
constexpr double slope_deviation = 0.4;
constexpr double bend_deviation = 0.07;   ///< deviation of c_2; higher terms fall with their order squared
constexpr double scatter_median = 0.005;  ///< where the noise is stated
constexpr double unstated_scatter_median =
    0.02;                               ///< prior when the file states no noise: assume a larger scatter
constexpr double scatter_spread = 1.3;  ///< of the logarithm

double square(double x) {
    return x * x;
}

}  // namespace

CurvePosterior::CurvePosterior(const CurveTable& table, const std::vector<RecordedImpact>& impacts,
                               const CurvePrior& prior)
    : table_(&table), impacts_(&impacts), prior_(prior) {
    for (const RecordedImpact& impact : impacts) {
        fastest_ = std::max(fastest_, impact.log_velocity);
        slowest_ = std::min(slowest_, impact.log_velocity);
    }
}

SmoothDamping CurvePosterior::curve(const Vector& parameters) const {
    std::array<double, SmoothDamping::terms> coefficients{};
    coefficients[0] = slope_mean + slope_deviation * parameters[first_term];
    // Coefficients fall as those of an integrated random walk.
    for (int k = 2; k <= SmoothDamping::terms; ++k)
        coefficients[static_cast<std::size_t>(k - 1)] =
            bend_deviation * square(2.0 / k) * parameters[first_term + k - 1];
    return {*table_, parameters[critical], fastest_, coefficients};
}

Scatter CurvePosterior::scatter_of(const Vector& parameters) const {
    const double median = prior_.noise_known ? scatter_median : unstated_scatter_median;
    return {
        .noise = (prior_.noise_known ? 1.0 : prior_.noise) * std::exp(parameters[noise]),
        .damping = prior_.scatter ? *prior_.scatter : median * std::exp(scatter_spread * parameters[scatter]),
        .outliers = outlier_share};
}

double CurvePosterior::prior_term(const Vector& parameters) const {
    double sum = 0.5 * (parameters.squaredNorm() - square(parameters[critical]) - square(parameters[noise]));
    sum += prior_.noise_known ? std::log1p(square(parameters[noise] / 0.1))
                              : 0.5 * square(parameters[noise] / 1.5);
    // Laboratories choose velocities around v_c, so v_c is unlikely to lie far below the slowest impact.
    constexpr double below = 1.2;
    constexpr double deviation = 0.4;
    return sum + 0.5 * square(std::max(0.0, slowest_ - below - parameters[critical]) / deviation);
}

double CurvePosterior::operator()(const Vector& parameters) const {
    constexpr double impossible = 1e10;
    const double a = parameters[critical];
    if (!(a > table_->lower() && a < table_->upper()) || !(parameters.cwiseAbs().maxCoeff() < 30.0))
        return impossible;
    const SmoothDamping fitted = curve(parameters);
    const Scatter scattered = scatter_of(parameters);
    double sum = prior_term(parameters) + fitted.lingering();
    for (const RecordedImpact& impact : *impacts_)
        sum -= impact.count * log_probability(fitted, scattered, impact);
    return std::isfinite(sum) ? sum : impossible;
}

CurvePosterior::Curvature CurvePosterior::curvature(const Vector& parameters, double value,
                                                    const Vector& steps) const {
    const auto at = [&](int i, double by_i, int j, double by_j) {
        Vector shifted = parameters;
        shifted[i] += by_i;
        shifted[j] += by_j;
        return (*this)(shifted);
    };
    Vector below;
    Matrix both;  // on the diagonal a step of one parameter, below it steps of two
    batch::for_each_item(static_cast<std::size_t>(size) * (size + 1), [&](std::size_t item) {
        const int i = static_cast<int>(item) / (size + 1);
        const int j = static_cast<int>(item) % (size + 1);
        if (j == size)
            below[i] = at(i, -steps[i], i, 0.0);
        else if (j <= i)
            both(i, j) = at(i, steps[i], j, j < i ? steps[j] : 0.0);
    });
    Curvature result{Vector::Zero(), Matrix::Zero()};
    for (int i = 0; i < size; ++i) {
        const double h = steps[i];
        result.gradient[i] = (both(i, i) - below[i]) / (2.0 * h);
        result.hessian(i, i) = (both(i, i) - 2.0 * value + below[i]) / (h * h);
        for (int j = 0; j < i; ++j)
            result.hessian(i, j) = result.hessian(j, i) =
                (both(i, j) - both(i, i) - both(j, j) + value) / (h * steps[j]);
    }
    return result;
}

}  // namespace ashimpact
