#include "solver/uncertainty/outcomes/rebound_check.hpp"

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/statistics/moments.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ashimpact {

namespace {

/// Standard uncertainties of an impact's velocities as the fit takes them.
struct FittedNoise {
    double incident;
    double rebound;
};

FittedNoise noise_in(const DampingCurveFit& fit, const Measurement& point) {
    if (!fit.noise_known || !point.noise) return {fit.scatter, fit.scatter};
    return {fit.scatter * std::sqrt(point.noise->incident), fit.scatter * std::sqrt(point.noise->rebound)};
}

}  // namespace

void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set) {
    const auto count = static_cast<double>(set.points.size());
    const double extreme = gsl::normal_quantile(1.0 - 0.5 * (1.0 - confidence) / count);
    std::optional<double> slowest;
    std::optional<double> bound;
    for (const Measurement& point : set.points) {
        const FittedNoise noise = noise_in(fit, point);
        if (point.captured() || point.rebound <= 3.0 * noise.rebound) continue;
        if (!slowest || point.velocity < *slowest) slowest = point.velocity;
        const double most = point.velocity + extreme * noise.incident;
        if (!bound || most < *bound) bound = most;
    }
    const Interval& fitted = fit.critical_velocity;
    const double least = fitted.lower.value_or(fitted.value - gsl::normal_quantile(0.5 + 0.5 * confidence) *
                                                                  fitted.standard_uncertainty);
    if (!bound || least <= *bound) return;
    throw InputError("the fitted v_c of " + shortest(fitted.value) +
                         " m/s lies above clear rebounds, the slowest at " + shortest(*slowest) + " m/s",
                     "impacts from the rising branch")
        .in_file(set.source);
}

std::optional<std::string> spacing_note(const MeasurementSet& set) {
    constexpr double apart = 2.0;     // standard uncertainties between neighbours of different steps
    constexpr double evenness = 0.3;  // deviation of even steps over their mean
    constexpr std::size_t fewest = 5;
    if (!set.has_noise()) return std::nullopt;
    std::vector<double> velocities;
    double variance = 0.0;
    for (const Measurement& point : set.points) {
        velocities.push_back(point.velocity);
        variance += point.noise->incident / static_cast<double>(set.points.size());
    }
    const double u = std::sqrt(variance);
    std::sort(velocities.begin(), velocities.end());
    std::vector<double> steps;
    double begin = velocities.front();
    for (std::size_t i = 1; i < velocities.size(); ++i) {
        if (velocities[i] - velocities[i - 1] <= apart * u) continue;
        steps.push_back(velocities[i] - begin);
        begin = velocities[i];
    }
    if (steps.size() < fewest) return std::nullopt;
    const Moments moments = Moments::of(steps);
    if (std::sqrt(moments.variance()) > evenness * moments.mean) return std::nullopt;
    return "the velocities stand in even steps of " + shortest(std::round(1e3 * moments.mean) / 1e3) +
           " m/s, " + shortest(std::round(10.0 * moments.mean / u) / 10.0) +
           " standard uncertainties: fits take all velocities as equally likely, and where a step lies at "
           "v_c the "
           "interval of the direct fit holds less often than stated";
}

}  // namespace ashimpact
