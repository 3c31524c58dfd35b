// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace ashimpact::gsl {

/// Quantile of the standard normal distribution, 0 < p < 1.
[[nodiscard]] double normal_quantile(double probability);

/// Probability of a standard normal variable below @p x.
[[nodiscard]] double normal_probability(double x);

/// Logarithm of normal_probability(), also if the probability itself underflows.
[[nodiscard]] double normal_log_probability(double x);

/// Slope of normal_log_probability(): density over probability.
[[nodiscard]] double normal_log_probability_slope(double x);

/// Quantile of Student's t; that of the normal distribution for 0 degrees of freedom.
[[nodiscard]] double student_quantile(double probability, int degrees_of_freedom);

/// Probability of a chi^2 at least this large; 1 for 0 degrees of freedom.
[[nodiscard]] double chi_squared_exceedance(double chi_squared, int degrees_of_freedom);

/// Probability that the ratio of two independent variances of equal expectation is at least @p ratio.
[[nodiscard]] double variance_ratio_exceedance(double ratio, double upper_freedom, double lower_freedom);

/// Probability of @p most or fewer successes in @p trials.
[[nodiscard]] double binomial_probability(unsigned most, double success, unsigned trials);

/// The quantiles of a sample, by linear interpolation (GSL statistics).
[[nodiscard]] std::vector<double> quantiles(std::vector<double> values, std::span<const double> fractions);

/// Median absolute deviation times 1.4826: the standard deviation of a normal sample with outliers.
[[nodiscard]] double robust_deviation(std::span<const double> values);

}  // namespace ashimpact::gsl
