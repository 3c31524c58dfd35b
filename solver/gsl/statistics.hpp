#pragma once

#include <span>
#include <vector>

namespace ashimpact::gsl {

/// Moments of numbers that are not kept (GSL rstat).
struct Moments {
    double mean;
    double deviation;  ///< standard deviation, n - 1
    double least;
    double greatest;
};
[[nodiscard]] Moments moments(std::span<const double> values);

/// The quantiles of a sample, by linear interpolation (GSL statistics).
[[nodiscard]] std::vector<double> quantiles(std::vector<double> values, std::span<const double> fractions);

/// Weighted mean; weights need not add up to one.
[[nodiscard]] double weighted_mean(std::span<const double> values, std::span<const double> weights);

/// Median absolute deviation times 1.4826: the standard deviation of a normal sample with outliers.
[[nodiscard]] double robust_deviation(std::span<const double> values);

/// Spearman's rank correlation [-1, 1].
[[nodiscard]] double rank_correlation(std::span<const double> x, std::span<const double> y);

}  // namespace ashimpact::gsl
