#include "solver/uncertainty/damping_curve_fit.hpp"

#include "materials/error.hpp"
#include "materials/text.hpp"
#include "solver/critical_velocity.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/uncertainty/likelihood_maximum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ashimpact {

namespace {

constexpr std::size_t most_profiled = 400;  ///< impacts up to which the profile likelihood is followed
constexpr double least_probability = 0.01;  ///< of the scatter, below which the noise is enlarged

double squared_distances(const RestitutionLikelihood& likelihood, const Eigen::VectorXd& coefficients) {
    const auto rebounds = static_cast<Eigen::Index>(likelihood.data().rebounds.size());
    return likelihood.rows(coefficients).residuals.head(rebounds).squaredNorm();
}

RestitutionData without_outcomes(RestitutionData data) {
    data.outcomes.clear();
    return data;
}

/// How well the rebounds alone are fitted, with the noise as given.
struct Goodness {
    double chi_squared;
    int degrees_of_freedom;
    double probability;
    double scatter;
};

Goodness goodness_of(const RestitutionLikelihood& likelihood, const Eigen::VectorXd& coefficients,
                     bool noise_known) {
    const auto& weights = likelihood.data().weights;
    const double effective = std::accumulate(weights.begin(), weights.end(), 0.0);
    const int freedom =
        std::max(0, static_cast<int>(std::lround(effective)) - static_cast<int>(coefficients.size()));
    const double chi_squared = squared_distances(likelihood, coefficients);
    const double probability = noise_known ? gsl::chi_squared_exceedance(chi_squared, freedom) : 1.0;
    const bool enlarge = !noise_known || probability < least_probability;
    const double scatter = enlarge && freedom > 0 ? std::sqrt(chi_squared / freedom) : 1.0;
    return {chi_squared, freedom, probability, scatter};
}

double corrected_akaike(const Goodness& goodness, bool noise_known, std::size_t points, int parameters) {
    const auto n = static_cast<double>(points);
    const double p = parameters + (noise_known ? 0 : 1);
    const double misfit = noise_known ? goodness.chi_squared : n * std::log(goodness.chi_squared / n);
    const double correction =
        n > p + 1 ? 2 * p * (p + 1) / (n - p - 1) : std::numeric_limits<double>::infinity();
    return misfit + 2 * p + correction;
}

double critical_velocity_at(const ContactModel& model, double damping) {
    if (const auto read = model.critical_velocity(damping)) return *read;
    const ScaledImpacts& impacts = model.map().impacts();
    return critical_velocity(
               {impacts.law(), impacts.detachment(), {DampingLaw::constant, damping}, model.contact()})
        .value.value_or(0.0);
}

/// v_c rises with eta_c, so its interval has the same ends.
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

void add_rebounds(DampingCurveFit& fit, const RestitutionLikelihood& likelihood,
                  const ReboundSelection& selection) {
    const auto& rows = likelihood.rows(fit.damping.coefficients);
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < selection.indices.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double weight = likelihood.data().weights[i];
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

Interval curvature_interval(double value, double deviation, double quantile) {
    Interval interval{value, deviation, value - quantile * deviation, value + quantile * deviation};
    if (*interval.lower <= 0.0) interval.lower = std::nullopt;
    return interval;
}

}  // namespace

DampingCurveFit fit_damping_curve(const ContactModel& model, const MeasurementSet& set,
                                  const DampingCurveOptions& options) {
    validate(set);
    ReboundSelection selection = select_rebounds(model, set);
    require_enough(selection, set, options.order);
    RestitutionData& data = selection.data;

    Eigen::VectorXd best =
        maximise(RestitutionLikelihood(model, data), starting_coefficients(model, data, options.order));
    if (options.robust) best = maximise_robustly(model, data, best);
    const Goodness goodness = goodness_of(RestitutionLikelihood(model, data), best, selection.noise_known);
    const double enlargement = goodness.scatter * goodness.scatter;
    for (Measurement& point : data.rebounds) point.noise = point.noise->scaled(enlargement);
    const std::size_t captures = options.captures ? set.captures() : 0;
    if (captures > 0) data.outcomes = outcomes_of(set, goodness.scatter);
    const RestitutionLikelihood likelihood(model, data);
    if (captures > 0) {
        const int lower = std::min(options.order, 2);
        const Eigen::VectorXd simple =
            maximise_upwards(RestitutionLikelihood(model, without_outcomes(data)), lower);
        best = maximise_from(likelihood, {best, raised(simple, options.order)});
    }

    const bool estimated = goodness.scatter != 1.0;
    const double quantile =
        gsl::student_quantile(0.5 + 0.5 * confidence, estimated ? goodness.degrees_of_freedom : 0);
    const bool profiled = data.rebounds.size() + data.outcomes.size() <= most_profiled;
    DampingCurveFit fit{};
    fit.options = options;
    fit.damping = {best};
    fit.covariance = likelihood.information(best).covariance();
    fit.interval_method = profiled ? IntervalMethod::profile_likelihood : IntervalMethod::curvature;
    fit.critical_damping = profiled ? profile_critical_damping(likelihood, best, quantile)
                                    : curvature_interval(best[0], std::sqrt(fit.covariance(0, 0)), quantile);
    fit.critical_velocity = critical_velocity_of(model, fit.critical_damping);
    fit.excluded = selection.excluded;
    fit.captures = captures;
    fit.chi_squared = goodness.chi_squared;
    fit.degrees_of_freedom = goodness.degrees_of_freedom;
    fit.probability = goodness.probability;
    fit.scatter = goodness.scatter;
    fit.noise_known = selection.noise_known;
    fit.akaike = corrected_akaike(goodness, selection.noise_known, data.rebounds.size(), options.order + 1);
    add_rebounds(fit, likelihood, selection);
    add_range(fit, data);
    return fit;
}

std::vector<DampingCurveFit> compare_orders(const ContactModel& model, const MeasurementSet& set,
                                            const std::vector<int>& orders, DampingCurveOptions options) {
    std::vector<DampingCurveFit> fits;
    for (const int order : orders) {
        options.order = order;
        try {
            fits.push_back(fit_damping_curve(model, set, options));
        } catch (const InputError&) {
            if (fits.empty()) throw;  // not even the lowest order
        }
    }
    return fits;
}

FitComparison compare(const DampingCurveFit& extrapolated, const DampingCurveFit& direct) {
    FitComparison result{};
    result.critical_damping_ratio = direct.critical_damping.value / extrapolated.critical_damping.value;
    result.critical_velocity_ratio = direct.critical_velocity.value / extrapolated.critical_velocity.value;
    result.consistent = direct.critical_damping.contains(extrapolated.critical_damping.value);
    result.exclude_one_another = disjoint(extrapolated.critical_damping, direct.critical_damping);
    result.statement = "critical velocity of the direct fit over that of the extrapolated one: " +
                       shortest(std::round(1e4 * result.critical_velocity_ratio) / 1e4);
    if (result.consistent) {
        result.statement += "; consistent: the extrapolated one lies within the direct 95 % interval";
    } else {
        const int order = extrapolated.options.order;
        result.statement += "; they disagree: a damping of order " + std::to_string(order) +
                            " in the restitution does not describe these impacts down to capture";
    }
    return result;
}

}  // namespace ashimpact
