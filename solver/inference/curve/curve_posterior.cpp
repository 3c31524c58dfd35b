// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/curve/curve_posterior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ashimpact {

namespace {

using Vector = OnsetCurve::Vector;
using Matrix = Eigen::Matrix<double, OnsetCurve::size, OnsetCurve::size>;

/// Normal prior of the coefficients: a, q and the tilt b_1 are hardly known, further bends fall with their
/// order squared and spread as in the curves of known laws (docs/uncertainty.md).
struct CoefficientPrior {
    Vector mean;
    Vector deviation;
};
const CoefficientPrior& coefficient_prior() {
    static const CoefficientPrior prior = [] {
        CoefficientPrior result{Vector::Zero(), Vector::Zero()};
        result.mean.head<2>() << -0.8, 0.9;
        result.deviation.head<3>() << 1.0, 0.45, 1.0;
        for (int k = 2; k <= OnsetCurve::bends; ++k) result.deviation[1 + k] = 0.35 * 4.0 / (k * k);
        return result;
    }();
    return prior;
}

/// Standard deviation of ln e about any curve of this form: far impacts say little about the onset.
constexpr double form_error = 0.04;
constexpr double outlier_share = 0.02;
constexpr double outliers_at_rest = 0.1;  ///< share of outliers that read zero

/// Rebound velocity over v - v_c of the slowest rebounds that are reckoned with where no curve is.
constexpr double slow_restitution = 0.05;

/// Degrees of freedom with which noise is known before: its logarithm within 0.2, or within a factor of 3.
constexpr double stated_freedom = 12.0;
constexpr double unstated_freedom = 0.5;

/// Scatter of ln v_c between particles, with the weights of a log-normal prior. Where it is wide, the two
/// ways in which particles may differ are as likely.
struct ScatterPrior {
    double threshold;
    bool fades;
    double stated;    ///< weight where the noise is stated
    double unstated;  ///< weight where it is not: particles are assumed to differ more
};
constexpr std::array scatters{ScatterPrior{0.003, false, 0.55, 0.25}, ScatterPrior{0.02, false, 0.28, 0.3},
                              ScatterPrior{0.06, false, 0.055, 0.11}, ScatterPrior{0.06, true, 0.055, 0.11},
                              ScatterPrior{0.15, false, 0.02, 0.07},  ScatterPrior{0.15, true, 0.02, 0.07},
                              ScatterPrior{0.4, false, 0.01, 0.045},  ScatterPrior{0.4, true, 0.01, 0.045}};

double square(double x) {
    return x * x;
}

double normal_below(double z) {
    return 0.5 * std::erfc(-z * std::numbers::sqrt2 / 2.0);
}

/// The standard normal distribution above a bound.
struct AboveBound {
    double share = 1.0;
    double mean = 0.0;
    double deviation = 1.0;

    [[nodiscard]] static AboveBound of(double bound) {
        const double share = normal_below(-bound);
        // Mills' ratio, by its continued fraction where both parts are tiny.
        const double density = std::exp(-0.5 * bound * bound) / std::sqrt(2.0 * std::numbers::pi);
        const double mean = bound > 8.0 ? bound + 1.0 / (bound + 2.0 / (bound + 3.0 / (bound + 4.0 / bound)))
                                        : density / share;
        return {share, mean, std::sqrt(std::max(1e-4, 1.0 - mean * (mean - bound)))};
    }
};

/// ln(v/v_c) at which the median particle keeps the restitution of this one, if they differ in the energy
/// that captures: v_eff^2 - v_c^2 = v^2 - v_own^2, with v_own the critical velocity of this one.
/// @param above ln(v/v_own) @param offset ln(v_own/v_c)
double place_by_energy(double above, double offset) {
    const double along = above + offset;
    return along + 0.5 * std::log(std::exp(-2.0 * along) - std::expm1(-2.0 * above));
}

/// Noise of v_in and differences between particles both shift an impact along ln v. Those shifts by which it
/// rebounds are represented by two of the same mean and variance. None of this depends on the coefficients of
/// the curve.
struct ShiftedImpact {
    struct Place {
        double y;         ///< ln(v/v_c)
        double incident;  ///< true v_in [m/s]
        Vector terms;     ///< of the curve at y
    };
    double width;     ///< standard deviation of the shift
    double share;     ///< of v_in in its variance
    double captured;  ///< probability
    bool fades;
    AboveBound rebounds{};
    double along = 0.0;      ///< change of the reading by that of v_in
    double rebound_u = 0.0;  ///< of the reading beside that [m/s]
    std::array<Place, 2> places{};

    ShiftedImpact(double log_critical, const Scatter& scatter, const RecordedImpact& impact)
        : fades(scatter.fades) {
        const double by_noise = scatter.noise * impact.incident_u / impact.velocity;
        width = std::hypot(by_noise, scatter.threshold);
        share = square(by_noise / width);
        const double from = (log_critical - impact.log_velocity) / width;
        captured = normal_below(from);
        if (impact.recorded == Recorded::capture) return;
        rebounds = AboveBound::of(from);
        along = impact.correlation * impact.rebound_u / impact.incident_u;
        rebound_u = scatter.noise * impact.rebound_u * std::sqrt(1.0 - square(impact.correlation));
        for (const int side : {-1, 1}) {
            const double shift = (rebounds.mean + side * rebounds.deviation) * width;
            const double above = impact.log_velocity + shift - log_critical;
            const double y =
                std::max(1e-6, fades ? place_by_energy(std::max(1e-6, above), (share - 1.0) * shift) : above);
            places[side < 0 ? 0 : 1] = {y, impact.velocity * std::exp(share * shift), OnsetCurve::terms(y)};
        }
    }
};

/// The record of one impact: its probability, and how the expected reading moves with the coefficients.
struct RecordFit {
    double probability;  ///< of a capture, or density of a reading [s/m]
    double regular;      ///< share of it that depends on the curve
    double residual = 0.0;
    double variance = 1.0;
    double by_noise = 0.0;          ///< share of the variance that is noise
    Vector slope = Vector::Zero();  ///< of the expected reading
};

/// @param coefficients of the curve @param addition to the deviation of readings, as a share of v_in
RecordFit fit_of(const Vector& coefficients, const ShiftedImpact& shifted, const RecordedImpact& impact,
                 double addition = 0.0) {
    const auto& [width, share, captured, fades, rebounds, along, rebound_u, places] = shifted;
    const double flat = 1.0 / (1.5 * impact.velocity);  // density of an outlier's reading
    if (impact.recorded == Recorded::capture) {
        const double regular = (1.0 - outlier_share) * captured;
        const double all = regular + outlier_share * outliers_at_rest;
        return {.probability = all, .regular = regular / all};
    }
    double mean = 0.0;
    double half = 0.0;
    double half_y = 0.0;
    double half_log = 0.0;  // of e
    double middle = 0.0;    // of y
    RecordFit fit{};
    for (const double side : {-1.0, 1.0}) {
        const auto& [y, incident, terms] = places[side < 0.0 ? 0 : 1];
        const double log_restitution = terms.dot(coefficients);
        const double r = incident * std::exp(std::min(1.0, log_restitution));
        middle += 0.5 * y;
        half_y += 0.5 * side * y;
        half_log += 0.5 * side * log_restitution;
        const double reading = r + along * (impact.velocity - incident);
        mean += 0.5 * reading;
        half += 0.5 * side * reading;
        fit.slope += 0.5 * r * terms;
    }
    // At an equal v/v_own noise of v_in moves the place on the curve only where the difference fades.
    const double moved = fades ? half_log / std::max(half_y, 1e-9) * -std::expm1(-2.0 * middle) : 0.0;
    const double by_incident = (mean * (1.0 + moved) - along * impact.velocity) * width;
    fit.variance = square(rebound_u) + square(half) + share * (1.0 - share) * square(by_incident) +
                   square(form_error * mean) + square(addition * impact.velocity);
    fit.by_noise =
        (square(rebound_u) + share * (square(half) + (1.0 - share) * square(by_incident))) / fit.variance;
    const double deviation = std::sqrt(fit.variance);
    double regular = 0.0;
    double outlier = outlier_share * flat;
    if (impact.recorded == Recorded::rebound) {
        fit.residual = impact.rebound - mean;
        regular = rebounds.share * std::exp(-0.5 * square(fit.residual) / fit.variance) /
                  (std::sqrt(2.0 * std::numbers::pi) * deviation);
        if (impact.resolution > 0.0) regular *= std::clamp(impact.rebound / impact.resolution, 1e-3, 1.0);
    } else {
        const double at_rest = impact.resolution > 0.0 ? std::clamp(1.0 - mean / impact.resolution, 0.0, 1.0)
                                                       : normal_below(-mean / deviation);
        regular = captured + rebounds.share * at_rest;
        outlier = outlier_share * outliers_at_rest;
    }
    fit.probability = (1.0 - outlier_share) * regular + outlier;
    fit.regular = (1.0 - outlier_share) * regular / fit.probability;
    return fit;
}

}  // namespace

Vector OnsetCurve::terms(double y) {
    const double s = y / (1.0 + y);
    const double t = 2.0 * s - 1.0;
    Vector result;
    result[0] = 1.0;
    result[1] = std::log(s);
    double before = 1.0;
    double now = t;
    for (int k = 0; k < bends; ++k) {
        result[2 + k] = now;
        const double next = 2.0 * t * now - before;
        before = now;
        now = next;
    }
    return result;
}

double OnsetCurve::restitution(double x) const {
    return x > critical_ ? std::exp(std::min(1.0, terms(x - critical_).dot(coefficients_))) : 0.0;
}

double log_probability(const OnsetCurve& curve, const Scatter& scatter, const RecordedImpact& impact) {
    const ShiftedImpact shifted(curve.log_critical_velocity(), scatter, impact);
    return std::log(fit_of(curve.coefficients(), shifted, impact).probability);
}

LikeliestCurve CurvePosterior::fitted(double log_critical_velocity, const Scatter& start) const {
    // Deviations of the readings, as shares of v_in, are added at first, so that no impact passes for an
    // outlier.
    constexpr std::array additions{0.4,  0.3,  0.2, 0.14, 0.1, 0.07, 0.05, 0.035,
                                   0.02, 0.01, 0.0, 0.0,  0.0, 0.0,  0.0,  0.0};
    static const std::array terms_along{OnsetCurve::terms(0.03), OnsetCurve::terms(0.3),
                                        OnsetCurve::terms(1.0), OnsetCurve::terms(2.0)};
    const CoefficientPrior& prior = coefficient_prior();
    const double freedom = prior_.noise_known ? stated_freedom : unstated_freedom;
    const double expected_noise = start.noise;
    Vector coefficients = prior.mean;
    Scatter scatter = start;
    double& noise = scatter.noise;
    double log_density = 0.0;
    std::vector<ShiftedImpact> shifted;
    double noise_of_shifts = 0.0;
    for (const double& addition : additions) {
        const bool last = &addition == &additions.back();
        if (noise != noise_of_shifts) {
            shifted.clear();
            for (const RecordedImpact& impact : *impacts_)
                shifted.emplace_back(log_critical_velocity, scatter, impact);
            noise_of_shifts = noise;
        }
        const Vector off = coefficients - prior.mean;
        Matrix precision = prior.deviation.cwiseAbs2().cwiseInverse().asDiagonal();
        Vector gradient = -(precision * off);
        log_density = 0.5 * gradient.dot(off) -
                      freedom * (std::log(noise / expected_noise) + 0.5 * square(expected_noise / noise));
        double count = 0.0;
        double noise_weight = 0.0;  // number of impacts, each by the share of noise in its variance
        double squares = 0.0;
        for (std::size_t i = 0; i < shifted.size(); ++i) {
            const RecordedImpact& impact = (*impacts_)[i];
            if (!last && impact.recorded != Recorded::rebound) continue;
            const RecordFit fit = fit_of(coefficients, shifted[i], impact, addition);
            if (last) log_density += impact.count * std::log(std::max(fit.probability, 1e-300));
            if (impact.recorded != Recorded::rebound) continue;
            const double weight = impact.count * fit.regular / fit.variance;
            gradient += weight * fit.residual * fit.slope;
            precision.selfadjointView<Eigen::Lower>().rankUpdate(fit.slope, weight);
            count += impact.count * fit.regular;
            noise_weight += impact.count * fit.regular * fit.by_noise;
            squares += weight * fit.by_noise * square(fit.residual);
        }
        const Eigen::LLT<Matrix> factor(precision.selfadjointView<Eigen::Lower>());
        if (last)
            log_density -=
                factor.matrixLLT().diagonal().array().log().sum() + prior.deviation.array().log().sum();
        const Vector step = factor.solve(gradient);
        double longest = 0.0;
        for (const Vector& terms : terms_along) longest = std::max(longest, std::abs(terms.dot(step)));
        coefficients += std::min(1.0, 1.5 / longest) * step;
        if (addition >= 0.015) continue;
        // Maximum likelihood of the noise: each impact counts by the share of noise in its variance, and the
        // degrees of freedom of the curve are subtracted.
        const Matrix inverse = factor.solve(Matrix::Identity());
        const double taken =
            OnsetCurve::size - inverse.diagonal().cwiseQuotient(prior.deviation.cwiseAbs2()).sum();
        noise = std::sqrt((square(noise) * squares + freedom * square(expected_noise)) /
                          (std::max(noise_weight * (1.0 - taken / std::max(count, 1.0)), 0.0) + freedom));
    }
    return {OnsetCurve(log_critical_velocity, coefficients), scatter, log_density};
}

LikeliestCurve CurvePosterior::at(double log_critical_velocity) const {
    std::optional<LikeliestCurve> best;
    double sum = 0.0;
    const auto add = [&](double threshold, bool fades, double weight) {
        const double noise = prior_.noise_known ? 1.0 : prior_.noise;
        LikeliestCurve curve = fitted(log_critical_velocity, {noise, threshold, fades});
        curve.log_density += std::log(weight);
        const bool better = !best || curve.log_density > best->log_density;
        const double most = better ? curve.log_density : best->log_density;
        sum = (best ? sum * std::exp(best->log_density - most) : 0.0) + std::exp(curve.log_density - most);
        if (better) best = curve;
    };
    if (prior_.scatter)
        add(*prior_.scatter, false, 1.0);
    else
        for (const ScatterPrior& scatter : scatters)
            add(scatter.threshold, scatter.fades, prior_.noise_known ? scatter.stated : scatter.unstated);
    best->log_density += std::log(sum);
    return *best;
}

double CurvePosterior::log_outcomes(double log_critical_velocity) const {
    double sum = 0.0;
    const double unit = prior_.noise_known ? 1.0 : prior_.noise;
    for (const RecordedImpact& impact : *impacts_) {
        const double width =
            std::hypot(unit * impact.incident_u / impact.velocity, prior_.scatter.value_or(0.01));
        const double captured = normal_below((log_critical_velocity - impact.log_velocity) / width);
        if (impact.recorded == Recorded::rebound) {
            sum += impact.count * std::log((1.0 - outlier_share) * (1.0 - captured) + outlier_share);
            continue;
        }
        double at_rest = captured;
        if (impact.recorded == Recorded::zero && impact.resolution > 0.0) {
            const double slow =
                slow_restitution * std::max(0.0, impact.velocity - std::exp(log_critical_velocity));
            at_rest += (1.0 - captured) * std::max(0.0, 1.0 - slow / impact.resolution);
        }
        sum += impact.count * std::log((1.0 - outlier_share) * at_rest + outlier_share * outliers_at_rest);
    }
    return sum;
}

}  // namespace ashimpact
