// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/extrapolation/damping_curve_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact {

namespace {

constexpr double least_probability = 0.01;  ///< of the scatter, below which the noise is enlarged

/// Goodness of a fit, with the noise as given.
struct Goodness {
    double chi_squared;
    int degrees_of_freedom;
    double probability;
    double scatter;
};

/// @param rows with the noise as it was measured, or 1 m/s
Goodness goodness_of(const RestitutionDistances::Rows& rows, const std::vector<double>& weights,
                     Eigen::Index parameters, bool noise_known) {
    constexpr double rounding = 1e-13;
    const double effective = std::accumulate(weights.begin(), weights.end(), 0.0);
    const int freedom = std::max(0, static_cast<int>(std::lround(effective)) - static_cast<int>(parameters));
    const double chi_squared = rows.residuals.squaredNorm();
    const double probability = noise_known ? gsl::chi_squared_exceedance(chi_squared, freedom) : 1.0;
    const bool enlarge = !noise_known || probability < least_probability;
    const double scatter = enlarge && freedom > 0 ? std::sqrt(chi_squared / freedom) : 1.0;
    return {chi_squared, freedom, probability, std::max(scatter, rounding)};
}

Interval curvature_interval(double value, double deviation, const Goodness& goodness) {
    const bool estimated = goodness.scatter != 1.0;
    const double quantile =
        gsl::student_quantile(0.5 + 0.5 * confidence, estimated ? goodness.degrees_of_freedom : 0);
    Interval interval{value, deviation, value - quantile * deviation, value + quantile * deviation};
    if (*interval.lower <= 0.0) interval.lower = std::nullopt;
    return interval;
}

double critical_velocity_at(const ContactModel& model, double damping) {
    return model.critical_velocity_anywhere(damping).value_or(0.0);
}

/// The interval of v_c from that of eta_c. v_c rises with eta_c, so the ends correspond.
Interval critical_velocity_of(const ContactModel& model, const Interval& damping) {
    const double value = critical_velocity_at(model, damping.value);
    const double nudge = 1e-4 * damping.value;
    const double slope = (critical_velocity_at(model, damping.value + nudge) -
                          critical_velocity_at(model, damping.value - nudge)) /
                         (2.0 * nudge);
    Interval velocity{value, slope * damping.standard_uncertainty};
    if (damping.lower) velocity.lower = critical_velocity_at(model, *damping.lower);
    if (damping.upper) velocity.upper = critical_velocity_at(model, *damping.upper);
    return velocity;
}

/// @param rows in units of the noise that explains the scatter
void add_rebounds(DampingCurveFit& fit, const RestitutionDistances::Rows& rows,
                  const ReboundSelection& selection) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < selection.indices.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double weight = selection.data.weights[i];
        const Eigen::VectorXd by_point = fit.covariance * rows.jacobian.row(row).transpose();
        const double leverage = rows.jacobian.row(row).dot(by_point);
        const double deleted = rows.residuals[row] / std::max(1.0 - leverage, 1e-12);
        const double root = weight > 0.0 ? std::sqrt(weight) : 1.0;
        fit.rebounds.push_back({.index = selection.indices[i],
                                .restitution = rows.restitutions[i],
                                .distance = rows.residuals[row] / root,
                                .leverage = leverage,
                                .deleted_distance = deleted / root,
                                .influence = by_point[0] * deleted,
                                .weight = weight});
        sum += deleted * deleted;
        weights += weight;
    }
    fit.prediction_error = std::sqrt(sum / weights);
}

void add_range(DampingCurveFit& fit, const RestitutionData& data) {
    fit.restitutions = {1.0, 0.0};
    for (const Measurement& point : data.rebounds) {
        fit.restitutions[0] = std::min(fit.restitutions[0], point.restitution());
        fit.restitutions[1] = std::max(fit.restitutions[1], point.restitution());
    }
    fit.extrapolation = fit.restitutions[0] / (fit.restitutions[1] - fit.restitutions[0]);
}

}  // namespace

DampingCurveFit fit_damping_curve(const ContactModel& model, const MeasurementSet& set,
                                  const DampingCurveOptions& options) {
    validate(set);
    ReboundSelection selection = select_rebounds(model, set, options.robust);
    require_enough(selection, set, options.order);
    RestitutionData& data = selection.data;
    const Eigen::VectorXd start = starting_coefficients(model, data, options.order, options.robust);
    const Eigen::VectorXd near =
        options.robust ? closest_robustly(model, data, start) : closest(model, data, start);
    RestitutionDistances::Rows rows = RestitutionDistances(model, data).rows(near);
    if (rows.restitutions.empty())
        throw ConvergenceError("the polynomial closest to the rebounds gives some of them at no velocity");
    if (!(near[0] > 0.0)) throw ConvergenceError("the polynomial gives no positive damping at e = 0");
    const Goodness goodness = goodness_of(rows, data.weights, near.size(), selection.noise_known);
    rows.residuals /= goodness.scatter;
    rows.jacobian /= goodness.scatter;

    DampingCurveFit fit{};
    fit.options = options;
    fit.damping = {near};
    fit.covariance = covariance_from(rows.jacobian);
    fit.critical_damping = curvature_interval(near[0], std::sqrt(fit.covariance(0, 0)), goodness);
    fit.critical_velocity = critical_velocity_of(model, fit.critical_damping);
    fit.excluded = selection.excluded;
    fit.chi_squared = goodness.chi_squared;
    fit.degrees_of_freedom = goodness.degrees_of_freedom;
    fit.probability = goodness.probability;
    fit.scatter = goodness.scatter;
    fit.noise_known = selection.noise_known;
    add_rebounds(fit, rows, selection);
    add_range(fit, data);
    return fit;
}

std::optional<std::string> enlargement_note(const DampingCurveFit& fit) {
    if (!fit.noise_known || fit.scatter == 1.0) return std::nullopt;
    return "the rebounds scatter " + shortest(std::round(100.0 * fit.scatter) / 100.0) +
           " times their stated uncertainty about a damping of order " + std::to_string(fit.options.order) +
           " in the restitution: uncertainties are enlarged by that";
}

}  // namespace ashimpact
