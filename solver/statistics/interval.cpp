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

}  // namespace ashimpact
