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

MarginalSample::MarginalSample(std::vector<std::pair<double, double>> values) : sorted_(std::move(values)) {
    std::sort(sorted_.begin(), sorted_.end());
}

double MarginalSample::quantile(double probability) const {
    double before = 0.0;
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
        const double here = (i > 0 ? before + 0.5 * sorted_[i - 1].second : 0.0) + 0.5 * sorted_[i].second;
        if (here >= probability) {
            if (i == 0) return sorted_[0].first;
            const double share = (probability - before) / (here - before);
            return sorted_[i - 1].first + share * (sorted_[i].first - sorted_[i - 1].first);
        }
        before = here;
    }
    return sorted_.back().first;
}

double MarginalSample::mean() const {
    double sum = 0.0;
    for (const auto& [x, share] : sorted_) sum += share * x;
    return sum;
}

double MarginalSample::standard_deviation() const {
    const double middle = mean();
    double sum = 0.0;
    for (const auto& [x, share] : sorted_) sum += share * (x - middle) * (x - middle);
    return std::sqrt(sum);
}

}  // namespace ashimpact
