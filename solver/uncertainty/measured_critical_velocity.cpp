#include "solver/uncertainty/measured_critical_velocity.hpp"

#include "solver/gsl/distribution.hpp"
#include "solver/gsl/nonlinear_fit.hpp"
#include "solver/uncertainty/profile.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

/// Square roots of -2 ln P of each outcome, for a transition at @p center.
Eigen::VectorXd residuals_of(const MeasurementSet& set, double center, double extra_variance, double least) {
    Eigen::VectorXd residuals(static_cast<Eigen::Index>(set.points.size()));
    Eigen::Index row = 0;
    for (const Measurement& point : set.points) {
        const double noise = point.noise ? point.noise->incident : least * least;
        const double z = (center - point.velocity) / std::sqrt(noise + extra_variance);
        residuals[row++] = std::sqrt(-2.0 * gsl::log_normal_probability(point.captured() ? z : -z));
    }
    return residuals;
}

double mean_noise(const MeasurementSet& set) {
    double sum = 0.0;
    for (const Measurement& point : set.points) sum += point.noise ? point.noise->incident : 0.0;
    return std::sqrt(sum / static_cast<double>(set.points.size()));
}

void note_range(const MeasurementSet& set, MeasuredCriticalVelocity& result) {
    for (const Measurement& point : set.points) {
        auto& end = point.captured() ? result.fastest_capture : result.slowest_rebound;
        const bool further = !end || (point.captured() ? point.velocity > *end : point.velocity < *end);
        if (further) end = point.velocity;
    }
}

/// One outcome only: v_c is bounded on one side, at the velocity that the nearest impact would just allow.
void bound_one_side(const MeasurementSet& set, MeasuredCriticalVelocity& result) {
    const double allowance = gsl::normal_quantile(confidence) * mean_noise(set);
    if (result.fastest_capture) {
        result.lower = *result.fastest_capture - allowance;
        result.note = "every impact was captured: v_c is not below the lower end";
    } else {
        result.upper = *result.slowest_rebound + allowance;
        result.note = "no impact was captured: v_c is not above the upper end";
    }
}

void take_gap(MeasuredCriticalVelocity& result) {
    result.lower = result.fastest_capture;
    result.upper = result.slowest_rebound;
    result.value = 0.5 * (*result.lower + *result.upper);
    result.standard_uncertainty = (*result.upper - *result.lower) / std::sqrt(12.0);
    result.note = "between the fastest capture and the slowest rebound";
}

/// Centre and width of a transition whose outcomes mix.
struct Transition {
    double center;
    double extra_variance;
};

Transition mixed_transition(const MeasurementSet& set, const MeasuredCriticalVelocity& seen, double unit) {
    Eigen::VectorXd start(2);
    start << 0.5 * (*seen.fastest_capture + *seen.slowest_rebound), unit;
    const auto fit = gsl::fit_nonlinear(
        [&](const Eigen::VectorXd& x) { return residuals_of(set, x[0], x[1] * x[1], 1e-3 * unit); }, start,
        {.parameter_tolerance = 1e-7, .gradient_tolerance = 1e-9});
    return {fit.parameters[0], fit.parameters[1] * fit.parameters[1]};
}

}  // namespace

MeasuredCriticalVelocity measured_critical_velocity(const MeasurementSet& set) {
    validate(set);
    MeasuredCriticalVelocity result;
    note_range(set, result);
    if (!result.fastest_capture || !result.slowest_rebound) {
        bound_one_side(set, result);
        return result;
    }
    const double noise = mean_noise(set);
    const bool mixed = *result.fastest_capture >= *result.slowest_rebound;
    if (!mixed && noise == 0.0) {
        take_gap(result);
        return result;
    }
    const double gap = std::abs(*result.fastest_capture - *result.slowest_rebound);
    const double unit = std::max({noise, gap, 1e-6 * *result.slowest_rebound});
    Transition transition{0.5 * (*result.fastest_capture + *result.slowest_rebound), 0.0};
    if (mixed) transition = mixed_transition(set, result, unit);
    const auto misfit = [&](double center) {
        return residuals_of(set, center, transition.extra_variance, 1e-3 * unit).squaredNorm();
    };
    const gsl::NonlinearFit best = gsl::fit_nonlinear(
        [&](const Eigen::VectorXd& x) {
            return residuals_of(set, x[0], transition.extra_variance, 1e-3 * unit);
        },
        Eigen::VectorXd::Constant(1, transition.center),
        {.parameter_tolerance = 1e-7, .gradient_tolerance = 1e-9});
    const double center = best.parameters[0];
    const double quantile = gsl::normal_quantile(0.5 + 0.5 * confidence);
    const Interval interval = profile_interval([&](double x) { return misfit(x) - misfit(center); },
                                               {.best = center,
                                                .deviation = std::max(noise, 0.3 * gap),
                                                .rise = quantile * quantile,
                                                .quantile = quantile,
                                                .least = 0.0,
                                                .greatest = 10.0 * center});
    result.value = interval.value;
    result.standard_uncertainty = interval.standard_uncertainty;
    result.lower = interval.lower;
    result.upper = interval.upper;
    result.width = std::sqrt(noise * noise + transition.extra_variance);
    result.note = mixed ? "outcomes mix between the slowest rebound and the fastest capture"
                        : "between the fastest capture and the slowest rebound, with their noise";
    return result;
}

std::string_view name_of(CriticalVelocityVerdict verdict) {
    switch (verdict) {
        case CriticalVelocityVerdict::agrees:
            return "agrees";
        case CriticalVelocityVerdict::model_too_low:
            return "model-too-low";
        case CriticalVelocityVerdict::model_too_high:
            return "model-too-high";
        case CriticalVelocityVerdict::not_comparable:
            return "not-comparable";
    }
    return {};
}

CriticalVelocityCheck check(const Interval& model, const MeasuredCriticalVelocity& measured) {
    if (!measured.value) {
        const bool low = measured.lower && model.upper && *model.upper < *measured.lower;
        const bool high = measured.upper && model.lower && *model.lower > *measured.upper;
        if (low) return {CriticalVelocityVerdict::model_too_low, {}};
        if (high) return {CriticalVelocityVerdict::model_too_high, {}};
        return {CriticalVelocityVerdict::not_comparable, {}};
    }
    const double joint = std::hypot(model.standard_uncertainty, *measured.standard_uncertainty);
    const double deviation = (model.value - *measured.value) / joint;
    const double limit = gsl::normal_quantile(0.5 + 0.5 * confidence);
    if (std::abs(deviation) <= limit) return {CriticalVelocityVerdict::agrees, deviation};
    return {
        deviation < 0.0 ? CriticalVelocityVerdict::model_too_low : CriticalVelocityVerdict::model_too_high,
        deviation};
}

}  // namespace ashimpact
