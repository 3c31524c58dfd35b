// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/gsl/statistics.hpp"

#include <algorithm>
#include <numbers>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sf_erf.h>
#include <gsl/gsl_statistics_double.h>

namespace ashimpact::gsl {

double normal_quantile(double probability) {
    return gsl_cdf_ugaussian_Pinv(probability);
}

double normal_probability(double x) {
    return gsl_cdf_ugaussian_P(x);
}

double normal_log_probability(double x) {
    return gsl_sf_log_erfc(-x / std::numbers::sqrt2) - std::numbers::ln2;
}

double normal_log_probability_slope(double x) {
    constexpr double no_density = 37.0;  // exp(-x^2/2) underflows soon beyond, an error to GSL
    return x > no_density ? 0.0 : gsl_sf_hazard(-x);
}

double student_quantile(double probability, int degrees_of_freedom) {
    return degrees_of_freedom > 0 ? gsl_cdf_tdist_Pinv(probability, degrees_of_freedom)
                                  : normal_quantile(probability);
}

double chi_squared_exceedance(double chi_squared, int degrees_of_freedom) {
    return degrees_of_freedom > 0 ? gsl_cdf_chisq_Q(chi_squared, degrees_of_freedom) : 1.0;
}

double variance_ratio_exceedance(double ratio, double upper_freedom, double lower_freedom) {
    return gsl_cdf_fdist_Q(ratio, upper_freedom, lower_freedom);
}

double binomial_probability(unsigned most, double success, unsigned trials) {
    return gsl_cdf_binomial_P(most, success, trials);
}

std::vector<double> quantiles(std::vector<double> values, std::span<const double> fractions) {
    std::ranges::sort(values);  // gsl_sort() takes twice as long
    std::vector<double> result;
    for (const double fraction : fractions)
        result.push_back(gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), fraction));
    return result;
}

double robust_deviation(std::span<const double> values) {
    std::vector<double> work(values.size());
    return gsl_stats_mad(values.data(), 1, values.size(), work.data());
}

}  // namespace ashimpact::gsl
