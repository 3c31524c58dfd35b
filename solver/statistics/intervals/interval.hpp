// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/numeric/gsl/distribution.hpp"

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

}  // namespace ashimpact
