// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/interval.hpp"

#include <algorithm>
#include <cmath>

#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

/// One end, in the direction of @p limit.
std::optional<double> end_towards(double limit, const std::function<double(double)>& profile,
                                  const ProfileSearch& search) {
    const double direction = limit > search.best ? 1.0 : -1.0;
    const double quantile = confidence_quantile();
    const double rise = quantile * quantile;
    // The square root of the rise is nearly linear in the parameter.
    const auto excess = [&](double x) { return std::sqrt(std::max(0.0, profile(x))) - std::sqrt(rise); };
    double inside = search.best;
    double step = direction * search.deviation * std::sqrt(rise);
    double outside = search.best + 1.1 * step;
    while (true) {
        if (direction * (outside - limit) >= 0.0) outside = limit;
        if (excess(outside) > 0.0) break;
        if (outside == limit) return std::nullopt;
        inside = outside;
        step *= 1.6;
        outside += step;
    }
    const gsl::RootOptions options{.relative = 0.0, .absolute = 1e-2 * search.deviation};
    return gsl::brent(excess, std::min(inside, outside), std::max(inside, outside), options).root;
}

}  // namespace

Interval profile_interval(const std::function<double(double)>& profile, const ProfileSearch& search) {
    Interval interval{.value = search.best,
                      .standard_uncertainty = search.deviation,
                      .lower = end_towards(search.least, profile, search),
                      .upper = end_towards(search.greatest, profile, search)};
    if (interval.lower && interval.upper)
        interval.standard_uncertainty = 0.5 * (*interval.upper - *interval.lower) / confidence_quantile();
    return interval;
}

Interval interval_of(const std::vector<LogNormalPart>& parts, double deviation) {
    double mean = 0.0;
    double square = 0.0;  // of the distance from the median of the first part, which loses no digits
    const double origin = std::exp(parts.front().log_median);
    double least = parts.front().log_median;
    double greatest = least;
    const double variance = deviation * deviation;
    for (const auto& [log_median, share] : parts) {
        const double here = std::exp(log_median + 0.5 * variance);
        mean += share * (here - origin);
        square += share * (here * here * std::expm1(variance) + (here - origin) * (here - origin));
        least = std::min(least, log_median);
        greatest = std::max(greatest, log_median);
    }
    const auto quantile = [&](double probability) {
        const auto excess = [&](double x) {
            double sum = 0.0;
            for (const auto& [log_median, share] : parts)
                sum += share * gsl::normal_probability((x - log_median) / deviation);
            return sum - probability;
        };
        constexpr double reach = 8.0;
        return std::exp(gsl::brent(excess, least - reach * deviation, greatest + reach * deviation,
                                   {.relative = 0.0, .absolute = 1e-12})
                            .root);
    };
    const double tail = 0.5 * (1.0 - confidence);
    return {origin + mean, std::sqrt(square - mean * mean), quantile(tail), quantile(1.0 - tail)};
}

}  // namespace ashimpact
