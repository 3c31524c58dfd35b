#pragma once

namespace ashimpact::gsl {

/// The x below which a standard normal variable falls with this probability, 0 < p < 1.
[[nodiscard]] double normal_quantile(double probability);

/// The probability that a standard normal variable falls below @p x.
[[nodiscard]] double normal_probability(double x);

/// Probability of a chi^2 at least this large; 1 without degrees of freedom.
[[nodiscard]] double chi_squared_exceedance(double chi_squared, int degrees_of_freedom);

}  // namespace ashimpact::gsl
