// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace ashimpact {

/// Sums of powers of the deviations of some values from a guess of their mean.
struct DeviationSums {
    double count = 0;
    double guess = 0;
    double first = 0;
    double second = 0;
    double third = 0;
    double fourth = 0;
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -std::numeric_limits<double>::infinity();
};

/// Count, extremes and central moments of some values. Moments of parts give the moments of the whole,
/// without the cancellation that power sums suffer: Pebay 2008, SAND2008-6212; Chan, Golub & LeVeque 1983 for
/// the variance.
struct Moments {
    std::uint64_t count = 0;
    double mean = 0;
    double second = 0;  ///< sum of the squared deviations from the mean
    double third = 0;   ///< sum of their cubes
    double fourth = 0;  ///< sum of their fourth powers
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -std::numeric_limits<double>::infinity();

    /// Moments of values, in two passes with pairwise sums.
    [[nodiscard]] static Moments of(std::span<const double> values);
    /// Moments from sums about a guess of the mean, which is near it.
    [[nodiscard]] static Moments of(const DeviationSums& sums);

    /// Makes these the moments of these values and those of @p other.
    void merge(const Moments& other);

    /// Unbiased variance; needs two values.
    [[nodiscard]] double variance() const;
    /// Skewness m3/m2^(3/2) and excess kurtosis m4/m2^2 - 3 [1]; need a variance that is not zero.
    [[nodiscard]] double skewness() const;
    [[nodiscard]] double excess_kurtosis() const;

    template <class Archive>
    void transfer(Archive& archive) {
        archive(count, mean, second, third, fourth, minimum, maximum);
    }
};

/// Sum of function(0), ..., function(count - 1) by halves: rounding grows with the logarithm of their number.
template <class Function>
[[nodiscard]] double pairwise_sum(std::size_t first, std::size_t count, const Function& function) {
    if (count > 128)
        return pairwise_sum(first, count / 2, function) +
               pairwise_sum(first + count / 2, count - count / 2, function);
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i) sum += function(i);
    return sum;
}

}  // namespace ashimpact
