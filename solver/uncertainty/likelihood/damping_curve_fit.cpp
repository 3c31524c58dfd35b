#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/uncertainty/likelihood/fitted_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ashimpact {

namespace {

/// -2 ln L + 2 p, corrected for few points; L as if all rebounds were as likely as those used.
double corrected_akaike(const FittedCurve& curve) {
    const auto n = static_cast<double>(curve.data.rebounds.size());
    const auto used = static_cast<double>(curve.used);
    const double p = static_cast<double>(curve.maximum.coefficients.size()) +
                     (curve.goodness.scatter == 1.0 ? 0.0 : 1.0);  // the noise is a parameter, too
    const double misfit = 2.0 * curve.maximum.value / used + 4.0 * std::log(curve.goodness.scatter);
    const double correction =
        n > p + 1.0 ? 2.0 * p * (p + 1.0) / (n - p - 1.0) : std::numeric_limits<double>::infinity();
    return n * misfit + 2.0 * p + correction;
}

double critical_velocity_at(const ContactModel& model, double damping) {
    return model.critical_velocity_anywhere(damping).value_or(0.0);
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

void add_rebounds(DampingCurveFit& fit, const ContactModel& model, const RestitutionData& data,
                  const ReboundSelection& selection) {
    const RestitutionDistances distances(model, data);
    const auto& rows = distances.rows(fit.damping.coefficients);
    const Eigen::MatrixXd covariance = covariance_from(rows.jacobian);
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < selection.indices.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double weight = data.weights[i];
        const Eigen::VectorXd by_point = covariance * rows.jacobian.row(row).transpose();
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

/// @param options the order becomes that of the fit
FittedCurve fit_of_order(const ContactModel& model, const ReboundSelection& selection,
                         DampingCurveOptions& options) {
    constexpr int lowest = 2;
    while (true) {
        try {
            return fit_curve(model, selection.data, options, selection.noise_known);
        } catch (const ConvergenceError&) {
            if (!options.lower_if_needed || options.order <= lowest) throw;
            --options.order;
        }
    }
}

}  // namespace

DampingCurveFit fit_damping_curve(const ContactModel& model, const MeasurementSet& set,
                                  const DampingCurveOptions& wanted) {
    validate(set);
    ReboundSelection selection = select_rebounds(model, set);
    require_enough(selection, set, wanted.order);
    if (wanted.captures) selection.data.captures = captures_of(set);
    DampingCurveOptions options = wanted;
    const FittedCurve curve = fit_of_order(model, selection, options);
    const Goodness& goodness = curve.goodness;

    DampingCurveFit fit{};
    fit.options = options;
    fit.damping = {curve.maximum.coefficients};
    fit.covariance = curve.maximum.covariance;
    fit.interval_method = curve.profiled ? IntervalMethod::profile_likelihood : IntervalMethod::curvature;
    fit.critical_damping = curve.critical_damping;
    fit.critical_velocity = critical_velocity_of(model, fit.critical_damping);
    fit.excluded = selection.excluded;
    fit.captures = curve.data.captures.size();
    fit.chi_squared = goodness.chi_squared;
    fit.degrees_of_freedom = goodness.degrees_of_freedom;
    fit.probability = goodness.probability;
    fit.scatter = goodness.scatter;
    fit.noise_known = selection.noise_known;
    fit.akaike = corrected_akaike(curve);
    add_rebounds(fit, model, curve.data, selection);
    add_range(fit, curve.data);
    return fit;
}

std::optional<std::string> enlargement_note(const DampingCurveFit& fit) {
    if (!fit.noise_known || fit.scatter == 1.0) return std::nullopt;
    return "the rebounds scatter " + shortest(std::round(100.0 * fit.scatter) / 100.0) +
           " times their stated uncertainty about a damping of order " + std::to_string(fit.options.order) +
           " in the restitution: uncertainties are enlarged by that";
}

OrderComparison compare_orders(const ContactModel& model, const MeasurementSet& set,
                               const std::vector<int>& orders, DampingCurveOptions options) {
    OrderComparison result;
    const auto miss = [&](int order, const std::string& reason) {
        result.notes.push_back("no fit of order " + std::to_string(order) + ": " + reason);
    };
    double least = std::numeric_limits<double>::infinity();
    for (const int order : orders) {
        options.order = order;
        try {
            result.fits.push_back(fit_damping_curve(model, set, options));
        } catch (const InputError& error) {
            miss(order, error.problem());
            continue;
        } catch (const ConvergenceError& error) {
            miss(order, error.what());
            continue;
        }
        if (!(result.fits.back().akaike < least)) continue;
        least = result.fits.back().akaike;
        result.best = order;
    }
    return result;
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
