// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact {

/// Probability with which every interval contains its result.
inline constexpr double confidence = 0.95;

/// A result with its standard uncertainty and 95 % interval. An end is missing if the data do not bound it.
struct Interval {
    double value;
    double standard_uncertainty;
    std::optional<double> lower{};
    std::optional<double> upper{};

    [[nodiscard]] bool contains(double x) const { return !(lower && x < *lower) && !(upper && x > *upper); }
};

/// Half width of the interval of a normally distributed result, in standard uncertainties: 1.96.
[[nodiscard]] inline double confidence_quantile() {
    return gsl::normal_quantile(0.5 + 0.5 * confidence);
}

/// Where an interval is searched on a profile of -2 ln L.
struct ProfileSearch {
    double best;       ///< position of the minimum
    double deviation;  ///< standard uncertainty there, the first guess of the width
    double least;      ///< lower bound of the parameter
    double greatest;   ///< upper bound of the parameter
};

/// Interval of a parameter from its profile: where -2 ln L, minimised over all other parameters, has risen by
/// the square of confidence_quantile() above its minimum. An end that is not reached within [least, greatest]
/// is missing. The standard uncertainty is that of a normal distribution with this interval.
/// @param profile rise above the minimum at a value of the parameter
[[nodiscard]] Interval profile_interval(const std::function<double(double)>& profile,
                                        const ProfileSearch& search);

/// A log-normal distribution that is part of another one.
struct LogNormalPart {
    double log_median;
    double share;  ///< of the whole [1]
};
/// Mean, standard deviation and 95 % interval of log-normal distributions together.
/// @param parts whose shares add up to 1 @param deviation > 0 of the logarithm, of each part
[[nodiscard]] Interval interval_of(const std::vector<LogNormalPart>& parts, double deviation);

}  // namespace ashimpact
