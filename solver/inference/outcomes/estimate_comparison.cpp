// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/outcomes/estimate_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact {

namespace {

/// Standard uncertainties of the velocities of an impact in a fit [m/s].
struct FittedNoise {
    double incident;
    double rebound;
};

FittedNoise noise_in(const DampingCurveFit& fit, const Measurement& point) {
    if (!fit.noise_known || !point.noise) return {fit.scatter, fit.scatter};
    return {fit.scatter * std::sqrt(point.noise->incident), fit.scatter * std::sqrt(point.noise->rebound)};
}

}  // namespace

double shared_difference(double one, double other) {
    const double more = std::max(one * one, other * other);
    const double less = std::min(one * one, other * other);
    return std::sqrt(std::max(more - less, 0.25 * more));
}

FitComparison compare(const DampingCurveFit& extrapolated, const Interval& critical_velocity,
                      const Interval& critical_damping) {
    // In logarithms, in which both are closer to normal; 3.5 leaves room for tails that are not.
    constexpr double limit = 3.5;
    const Interval& other = extrapolated.critical_velocity;
    FitComparison result{};
    result.critical_damping_ratio = critical_damping.value / extrapolated.critical_damping.value;
    result.critical_velocity_ratio = critical_velocity.value / other.value;
    const double allowed =
        limit * shared_difference(critical_velocity.standard_uncertainty / critical_velocity.value,
                                  other.standard_uncertainty / other.value);
    result.consistent = std::abs(std::log(result.critical_velocity_ratio)) <= allowed ||
                        critical_velocity.contains(other.value);
    result.exclude_one_another = !result.consistent;
    result.statement = "critical velocity of the estimate over that of the extrapolation: " +
                       shortest(std::round(1e4 * result.critical_velocity_ratio) / 1e4);
    if (result.consistent) {
        result.statement += "; they agree, as far as two estimates from the same impacts can tell";
    } else {
        result.statement += "; they disagree: a damping of order " +
                            std::to_string(extrapolated.options.order) +
                            " in the restitution does not describe these impacts down to capture";
    }
    return result;
}

void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set) {
    const auto count = static_cast<double>(set.points.size());
    const double extreme = gsl::normal_quantile(1.0 - 0.5 * (1.0 - confidence) / count);
    std::optional<double> slowest;
    std::optional<double> bound;
    std::vector<bool> outlying(set.points.size(), false);
    for (const FittedRebound& rebound : fit.rebounds) outlying[rebound.index] = rebound.weight < 0.5;
    for (const ExcludedRebound& rebound : fit.excluded) outlying[rebound.index] = true;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        if (outlying[i]) continue;
        const Measurement& point = set.points[i];
        const FittedNoise noise = noise_in(fit, point);
        if (point.captured() || point.rebound <= 3.0 * noise.rebound) continue;
        if (!slowest || point.velocity < *slowest) slowest = point.velocity;
        const double most = point.velocity + extreme * noise.incident;
        if (!bound || most < *bound) bound = most;
    }
    const Interval& fitted = fit.critical_velocity;
    const double least =
        fitted.lower.value_or(fitted.value - confidence_quantile() * fitted.standard_uncertainty);
    if (!bound || least <= *bound) return;
    throw InputError("the fitted v_c of " + shortest(fitted.value) +
                         " m/s lies above clear rebounds, the slowest at " + shortest(*slowest) + " m/s",
                     "impacts from the rising branch")
        .at(FileName{set.source});
}

}  // namespace ashimpact
