// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/outcomes/measured_critical_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/inference/curve/impact_groups.hpp"
#include "solver/inference/outcomes/capture_transition.hpp"
#include "solver/inference/outcomes/estimate_comparison.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

namespace {

/// The set; if it states no noise and has enough rebounds, with the noise estimated from their scatter.
MeasurementSet with_noise(const MeasurementSet& set) {
    constexpr std::size_t enough = 6;
    MeasurementSet result = set;
    if (set.has_noise() || set.rebounds() < enough) return result;
    const double u = noise_of_neighbours(recorded_impacts(set));
    if (u > 0.0)
        for (Measurement& point : result.points) point.noise = VelocityNoise::of_velocities(u, u);
    return result;
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

/// If only one outcome was seen, v_c is bounded on one side. Each of n impacts gives a bound from its
/// velocity and error, and the tightest is taken. It holds if all of them hold, so each may fail with
/// probability (1 - confidence)/n: the fastest of many captures is likely to be the one with the largest
/// error.
void bound_one_side(const MeasurementSet& set, MeasuredCriticalVelocity& result) {
    const double share = (1.0 - confidence) / static_cast<double>(set.points.size());
    const double quantile = -gsl::normal_quantile(share);
    double lower = 0.0;
    double upper = std::numeric_limits<double>::infinity();
    for (const Measurement& point : set.points) {
        const double allowance = quantile * (point.noise ? std::sqrt(point.noise->incident) : 0.0);
        lower = std::max(lower, point.velocity - allowance);
        upper = std::min(upper, point.velocity + allowance);
    }
    if (result.fastest_capture) {
        if (lower > 0.0) result.lower = lower;
        result.note = "every impact was captured";
    } else {
        result.upper = upper;
        result.note = "no impact was captured";
    }
}

/// True if captures may be unseen slow rebounds: the slowest rebounds were hardly faster than what the camera
/// resolves, and the captures were not seen to stick.
bool may_be_slow_rebounds(const MeasurementSet& set) {
    std::vector<const Measurement*> rebounds;
    bool seen_to_stick = true;
    for (const Measurement& point : set.points) {
        if (!point.captured())
            rebounds.push_back(&point);
        else if (point.outcome != NotedOutcome::capture)
            seen_to_stick = false;
    }
    const std::size_t slowest = std::min(rebounds.size(), std::max<std::size_t>(3, rebounds.size() / 10));
    if (seen_to_stick || slowest < 3) return false;
    std::ranges::sort(rebounds, {}, &Measurement::velocity);
    const auto hardly_seen = [](const Measurement* point) {
        constexpr double often = 1.5;  // below so many standard uncertainties 7 % or more read zero or less
        const double noise = point->noise ? std::sqrt(point->noise->rebound) : 0.0;
        return point->rebound < std::max(often * noise, point->resolution);
    };
    return 2 * std::count_if(rebounds.begin(), rebounds.begin() + static_cast<std::ptrdiff_t>(slowest),
                             hardly_seen) >
           static_cast<std::ptrdiff_t>(slowest);
}

void take_gap(MeasuredCriticalVelocity& result) {
    result.lower = result.fastest_capture;
    result.upper = result.slowest_rebound;
    result.value = 0.5 * (*result.lower + *result.upper);
    result.standard_uncertainty = (*result.upper - *result.lower) / std::sqrt(12.0);
    result.note = "between the fastest capture and the slowest rebound";
}

/// Both outcomes at one velocity of unknown uncertainty: this is v_c, without an interval.
void take_common_velocity(MeasuredCriticalVelocity& result) {
    result.value = result.fastest_capture;
    result.note = "captures end and rebounds begin at one velocity, whose uncertainty is not known";
}

void take_transition(const MeasurementSet& set, double noise, bool mixed, MeasuredCriticalVelocity& result) {
    const double gap = std::abs(*result.fastest_capture - *result.slowest_rebound);
    const OutcomeLikelihood likelihood(set, 1e-3 * std::max(noise, gap));
    const auto found = mixed ? likelihood.best() : CaptureTransition{likelihood.best_center(0.0), 0.0};
    if (!found || found->center <= 0.0) {
        result.note = reversed_share(set) >= 0.5
                          ? "outcomes contradict a threshold: captures are faster than rebounds"
                          : "outcomes hang on the velocity too little for a threshold";
        return;
    }
    const double width = std::sqrt(noise * noise + found->extra_variance);
    const double least = likelihood.misfit(*found);
    const Interval interval =
        profile_interval([&](double center) { return likelihood.profile(center) - least; },
                         {.best = found->center,
                          .deviation = std::max(width, 0.3 * gap),
                          .least = 0.0,
                          .greatest = 10.0 * found->center});
    result.value = interval.value;
    result.standard_uncertainty = interval.standard_uncertainty;
    result.lower = interval.lower;
    result.upper = interval.upper;
    result.width = width;
    result.note = mixed ? "outcomes mix between the slowest rebound and the fastest capture"
                        : "between the fastest capture and the slowest rebound, with their noise";
}

}  // namespace

MeasuredCriticalVelocity measured_critical_velocity(const MeasurementSet& stated) {
    validate(stated);
    const MeasurementSet set = with_noise(stated);
    MeasuredCriticalVelocity result;
    note_range(set, result);
    if (!result.fastest_capture || !result.slowest_rebound) {
        bound_one_side(set, result);
        return result;
    }
    const double noise = mean_noise(set);
    const bool mixed = *result.fastest_capture >= *result.slowest_rebound;
    if (noise == 0.0 && !mixed)
        take_gap(result);
    else if (noise == 0.0 && *result.fastest_capture == *result.slowest_rebound)
        take_common_velocity(result);
    else
        take_transition(set, noise, mixed, result);
    if (result.lower && may_be_slow_rebounds(set)) {
        result.lower.reset();
        result.note +=
            "; v_c may be lower, as the slowest rebounds can hardly be told from captures, which may be "
            "rebounds";
    }
    return result;
}

CriticalVelocityCheck check(const Interval& model, const MeasuredCriticalVelocity& measured,
                            bool same_impacts) {
    if (!measured.value) {
        const bool low = measured.lower && model.upper && *model.upper < *measured.lower;
        const bool high = measured.upper && model.lower && *model.lower > *measured.upper;
        if (low) return {CriticalVelocityVerdict::model_too_low, {}};
        if (high) return {CriticalVelocityVerdict::model_too_high, {}};
        return {CriticalVelocityVerdict::not_comparable, {}};
    }
    const double own = measured.standard_uncertainty.value_or(0.0);
    const double joint = same_impacts ? shared_difference(model.standard_uncertainty, own)
                                      : std::hypot(model.standard_uncertainty, own);
    if (!(joint > 0.0)) return {CriticalVelocityVerdict::not_comparable, {}};
    const double deviation = (model.value - *measured.value) / joint;
    if (std::abs(deviation) <= confidence_quantile()) return {CriticalVelocityVerdict::agrees, deviation};
    if (deviation > 0.0) return {CriticalVelocityVerdict::model_too_high, deviation};
    const bool from_above = measured.upper && !measured.lower;
    return {from_above ? CriticalVelocityVerdict::not_comparable : CriticalVelocityVerdict::model_too_low,
            deviation};
}

}  // namespace ashimpact
