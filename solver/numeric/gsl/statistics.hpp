// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace ashimpact::gsl {

/// The quantiles of a sample, by linear interpolation (GSL statistics).
[[nodiscard]] std::vector<double> quantiles(std::vector<double> values, std::span<const double> fractions);

/// Weighted mean; weights need not add up to one.
[[nodiscard]] double weighted_mean(std::span<const double> values, std::span<const double> weights);

/// Median absolute deviation times 1.4826: the standard deviation of a normal sample with outliers.
[[nodiscard]] double robust_deviation(std::span<const double> values);

}  // namespace ashimpact::gsl
