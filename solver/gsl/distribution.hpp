#pragma once

namespace ashimpact::gsl {

/// The x below which a standard normal variable falls with this probability, 0 < p < 1.
[[nodiscard]] double normal_quantile(double probability);

/// Probability of a standard normal variable below @p x.
[[nodiscard]] double normal_probability(double x);

/// Logarithm of normal_probability(), also where that is too small for a number.
[[nodiscard]] double normal_log_probability(double x);

/// Slope of normal_log_probability(): density over probability.
[[nodiscard]] double normal_log_probability_slope(double x);

/// Both in a tenth of the time. The logarithm has the rounding error of a number near 1, however small it is
/// itself.
[[nodiscard]] double quick_normal_log_probability(double x);
[[nodiscard]] double quick_normal_log_probability_slope(double x);

/// The x below which Student's t falls with this probability; that of the normal for 0 degrees of freedom.
[[nodiscard]] double student_quantile(double probability, int degrees_of_freedom);

/// Probability of a chi^2 at least this large; 1 without degrees of freedom.
[[nodiscard]] double chi_squared_exceedance(double chi_squared, int degrees_of_freedom);

/// The chi^2 below which the distribution falls with this probability.
[[nodiscard]] double chi_squared_quantile(double probability, int degrees_of_freedom);

/// Probability of @p most or fewer successes in @p trials.
[[nodiscard]] double binomial_probability(unsigned most, double success, unsigned trials);

/// Quantiles of the distributions that inputs are given in.
[[nodiscard]] double lognormal_quantile(double probability, double log_mean, double log_deviation);
[[nodiscard]] double uniform_quantile(double probability, double lower, double upper);

}  // namespace ashimpact::gsl
