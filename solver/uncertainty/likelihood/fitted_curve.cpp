#include "solver/uncertainty/likelihood/fitted_curve.hpp"

#include "materials/base/error.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/uncertainty/likelihood/rebound_selection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

namespace {

constexpr double least_probability = 0.01;  ///< of the scatter, below which the noise is enlarged

/// @param data with the noise as it was measured, or 1 m/s
Goodness goodness_of(const ContactModel& model, const RestitutionData& data,
                     const Eigen::VectorXd& coefficients, bool noise_known) {
    constexpr double rounding = 1e-13;
    const double effective = std::accumulate(data.weights.begin(), data.weights.end(), 0.0);
    const int freedom =
        std::max(0, static_cast<int>(std::lround(effective)) - static_cast<int>(coefficients.size()));
    const double chi_squared = RestitutionDistances(model, data).rows(coefficients).residuals.squaredNorm();
    const double probability = noise_known ? gsl::chi_squared_exceedance(chi_squared, freedom) : 1.0;
    const bool enlarge = !noise_known || probability < least_probability;
    const double scatter = enlarge && freedom > 0 ? std::sqrt(chi_squared / freedom) : 1.0;
    return {chi_squared, freedom, probability, std::max(scatter, rounding)};
}

/// Some hundred impacts of many, evenly over the velocities: enough to come close to the curve.
RestitutionData thinned(const RestitutionData& data) {
    const std::size_t step = data.rebounds.size() / few_rebounds + 1;
    if (step == 1) return data;
    std::vector<std::size_t> order(data.rebounds.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return data.rebounds[a].velocity < data.rebounds[b].velocity;
    });
    RestitutionData few{{}, {}, {}, data.greatest_restitution};
    for (std::size_t i = 0; i < order.size(); i += step) {
        few.rebounds.push_back(data.rebounds[order[i]]);
        few.weights.push_back(data.weights[order[i]]);
    }
    for (std::size_t i = 0; i < data.captures.size(); i += step) few.captures.push_back(data.captures[i]);
    return few;
}

/// A curve of that order close to the rebounds, robust if asked for; weights are left in @p data.
Eigen::VectorXd curve_close_to(const ContactModel& model, RestitutionData& data,
                               const DampingCurveOptions& options) {
    const RestitutionData few = thinned(data);
    Eigen::VectorXd near = starting_coefficients(model, few, options.order);
    try {
        near = closest(model, few, near);
        if (options.robust) near = closest_robustly(model, data, near);
    } catch (const ConvergenceError&) {  // the likelihood is smoother than distances are
    }
    return near;
}

Eigen::VectorXd raised(const Eigen::VectorXd& coefficients, int order) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(order + 1);
    result.head(coefficients.size()) = coefficients;
    return result;
}

/// The best curve where the noise is negligible: the closest one.
LikelihoodMaximum closest_maximum(const ContactModel& model, const RestitutionData& data,
                                  const Eigen::VectorXd& coefficients) {
    const RestitutionDistances distances(model, data);
    const auto& rows = distances.rows(coefficients);
    const double length =
        std::log(data.rebounds.front().noise->incident);  // as in the likelihood's integrals
    const double value =
        0.5 * (rows.residuals.squaredNorm() - length * static_cast<double>(data.rebounds.size()));
    return {coefficients, value, covariance_from(rows.jacobian)};
}

Interval curvature_interval(double value, double deviation, double quantile) {
    Interval interval{value, deviation, value - quantile * deviation, value + quantile * deviation};
    if (*interval.lower <= 0.0) interval.lower = std::nullopt;
    return interval;
}

double quantile_for(const Goodness& goodness) {
    const bool estimated = goodness.scatter != 1.0;
    return gsl::student_quantile(0.5 + 0.5 * confidence, estimated ? goodness.degrees_of_freedom : 0);
}

FittedCurve closest_fit(const ContactModel& model, const RestitutionData& data, const Goodness& goodness,
                        const Eigen::VectorXd& near) {
    FittedCurve fit{};
    fit.goodness = goodness;
    fit.data = data.with_noise_scaled(goodness.scatter * goodness.scatter);
    fit.data.captures.clear();
    fit.used = data.rebounds.size();
    fit.maximum = closest_maximum(model, fit.data, near);
    const double deviation = std::sqrt(fit.maximum.covariance(0, 0));
    fit.critical_damping = curvature_interval(near[0], deviation, quantile_for(goodness));
    return fit;
}

/// The most likely curve, the best of what is reached from a close one, from least squares and from the most
/// likely quadratic: the curve closest to impacts that no such damping describes may fold, and lead to
/// another one.
LikelihoodMaximum likeliest_from(ImpactLikelihood& likelihood, const Eigen::VectorXd& near) {
    const int order = static_cast<int>(near.size()) - 1;
    std::vector<Eigen::VectorXd> starts{near,
                                        starting_coefficients(likelihood.model(), likelihood.data(), order)};
    if (order > 2) {
        const Eigen::VectorXd start = starting_coefficients(likelihood.model(), likelihood.data(), 2);
        ImpactLikelihood quadratic(likelihood.model(), likelihood.data(), start);
        try {
            starts.push_back(raised(maximise(quadratic, start).coefficients, order));
        } catch (const ConvergenceError&) {  // the close one may do
        }
    }
    try {
        return maximise_from(likelihood, starts);
    } catch (const ConvergenceError& error) {
        throw ConvergenceError(
            "no damping of order " + std::to_string(order) + " in the restitution describes these " +
            std::to_string(likelihood.data().rebounds.size()) + " rebounds (" + error.what() +
            "); try another order or law, or leave out impacts that the law does not hold "
            "for, such as the fastest");
    }
}

/// The most likely curve of many impacts, from that of a few of them. Where all have none close by, that of
/// the few stands, with its own, wider covariance.
LikelihoodMaximum refined(ImpactLikelihood& likelihood, const LikelihoodMaximum& few, double share) {
    try {
        return maximise(likelihood, few.coefficients, share * few.covariance);
    } catch (const ConvergenceError&) {
        likelihood.move_to(few.coefficients);
        const auto at = likelihood.at(few.coefficients);
        if (!at) throw;
        return {few.coefficients, at->value, few.covariance};
    }
}

/// The same with other noise.
LikelihoodMaximum likeliest_again(ImpactLikelihood& likelihood, const Eigen::VectorXd& near) {
    try {
        return maximise(likelihood, near);
    } catch (const ConvergenceError&) {
        return likeliest_from(likelihood, near);
    }
}

/// With the noise of @p goodness, which depends, weakly, on the curve where it is estimated. Of many impacts
/// a few hundred tell it, and where to start.
FittedCurve likeliest_fit(const ContactModel& model, const RestitutionData& data, Goodness goodness,
                          Eigen::VectorXd near, bool noise_known) {
    constexpr int most_passes = 4;
    FittedCurve fit{};
    RestitutionData used;
    std::optional<ImpactLikelihood> likelihood;
    for (int pass = 1; pass <= most_passes; ++pass) {
        fit.goodness = goodness;
        fit.data = data.with_noise_scaled(goodness.scatter * goodness.scatter);
        const double variance = goodness.scatter * goodness.scatter;
        used = noise_known ? away_from_fastest(data).with_noise_scaled(variance)  // the same for every order
                           : away_from_fastest(fit.data);
        likelihood.emplace(model, thinned(used), near);
        fit.maximum = pass == 1 ? likeliest_from(*likelihood, near) : likeliest_again(*likelihood, near);
        near = fit.maximum.coefficients;
        goodness = goodness_of(model, data, near, noise_known);
        if (std::abs(goodness.scatter / fit.goodness.scatter - 1.0) < 0.01) break;
    }
    const std::size_t few = likelihood->data().rebounds.size();
    fit.used = used.rebounds.size();
    if (few < fit.used) {
        likelihood.emplace(model, used, near);
        fit.maximum =
            refined(*likelihood, fit.maximum, static_cast<double>(few) / static_cast<double>(fit.used));
        near = fit.maximum.coefficients;
        goodness = goodness_of(model, data, near, noise_known);
    }
    goodness.scatter = fit.goodness.scatter;
    fit.goodness = goodness;
    const double quantile = quantile_for(goodness);
    fit.critical_damping = curvature_interval(near[0], std::sqrt(fit.maximum.covariance(0, 0)), quantile);
    if (data.rebounds.size() + data.captures.size() > few_rebounds) return fit;
    try {
        likelihood->move_to(near);
        fit.critical_damping = profile_critical_damping(*likelihood, fit.maximum, quantile);
        fit.profiled = true;
    } catch (const ConvergenceError&) {
        fit.profiled = false;  // the curvature's interval stays, and says what it is
    }
    return fit;
}

}  // namespace

FittedCurve fit_curve(const ContactModel& model, RestitutionData data, const DampingCurveOptions& options,
                      bool noise_known) {
    const Eigen::VectorXd near = curve_close_to(model, data, options);
    const Goodness goodness = goodness_of(model, data, near, noise_known);
    const auto curve = RestitutionCurve::of(model, {near}, data.greatest_restitution);
    const RestitutionData scaled = data.with_noise_scaled(goodness.scatter * goodness.scatter);
    if (curve && ImpactLikelihood::noise_is_negligible(*curve, scaled))
        return closest_fit(model, data, goodness, closest(model, data, near));
    return likeliest_fit(model, data, goodness, near, noise_known);
}

}  // namespace ashimpact
