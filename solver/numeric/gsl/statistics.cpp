// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/statistics.hpp"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

namespace ashimpact::gsl {

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

}  // namespace ashimpact::gsl
