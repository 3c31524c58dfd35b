#include "solver/gsl/statistics.hpp"

#include "solver/gsl/status.hpp"

#include <gsl/gsl_rstat.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include <memory>

namespace ashimpact::gsl {

Moments moments(std::span<const double> values) {
    quiet();
    const std::unique_ptr<gsl_rstat_workspace, decltype(&gsl_rstat_free)> running(gsl_rstat_alloc(),
                                                                                  &gsl_rstat_free);
    for (const double value : values) check(gsl_rstat_add(value, running.get()), "moments");
    return {.mean = gsl_rstat_mean(running.get()),
            .deviation = gsl_rstat_sd(running.get()),
            .least = gsl_rstat_min(running.get()),
            .greatest = gsl_rstat_max(running.get())};
}

std::vector<double> quantiles(std::vector<double> values, std::span<const double> fractions) {
    gsl_sort(values.data(), 1, values.size());
    std::vector<double> result;
    for (const double fraction : fractions)
        result.push_back(gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), fraction));
    return result;
}

double weighted_mean(std::span<const double> values, std::span<const double> weights) {
    return gsl_stats_wmean(weights.data(), 1, values.data(), 1, values.size());
}

double robust_deviation(std::span<const double> values) {
    std::vector<double> work(values.size());
    return gsl_stats_mad(values.data(), 1, values.size(), work.data());
}

double rank_correlation(std::span<const double> x, std::span<const double> y) {
    std::vector<double> work(2 * x.size());
    return gsl_stats_spearman(x.data(), 1, y.data(), 1, x.size(), work.data());
}

}  // namespace ashimpact::gsl
