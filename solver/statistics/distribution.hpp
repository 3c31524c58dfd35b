// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace ashimpact {

/// Equally probable values; a list or a grid drawn from at random.
struct Choice {
    std::vector<double> values;
};

struct Uniform {
    double from;
    double to;
};

/// The logarithm is uniform; 0 < from < to.
struct LogUniform {
    double from;
    double to;
};

/// Normal, cut off outside [minimum, maximum] and normalised again.
struct Normal {
    double mean;
    double standard_deviation;
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
};

/// The logarithm is normal: half of the values are below the median, 68 % within a factor of the geometric
/// standard deviation around it. Cut off outside [minimum, maximum] and normalised again.
struct LogNormal {
    double median;
    double geometric_standard_deviation;  ///< above 1
    double minimum = 0;
    double maximum = std::numeric_limits<double>::infinity();
};

/// Density rising linearly to the mode and falling from there; from <= mode <= to, from < to.
struct Triangular {
    double from;
    double mode;
    double to;
};

using Distribution = std::variant<Choice, Uniform, LogUniform, Normal, LogNormal, Triangular>;

/// Distributions of a quantity from its value and standard uncertainty, both [SI].
[[nodiscard]] Distribution normal_around(double value, double standard_uncertainty);
/// The value is the median; the logarithm has the standard deviation standard_uncertainty/value. Never
/// negative; needs value > 0.
[[nodiscard]] Distribution lognormal_around(double value, double standard_uncertainty);

/// Replaces probabilities in (0, 1) by the quantiles of the distribution.
void to_quantiles(const Distribution& distribution, std::span<double> probabilities);

/// The least and the greatest value of a distribution; infinite if it is not bounded.
struct Support {
    double lowest;
    double highest;
};
[[nodiscard]] Support support_of(const Distribution& distribution);

/// Points from one value to another, both included and met exactly.
[[nodiscard]] std::vector<double> linear_grid(double from, double to, int points);
[[nodiscard]] std::vector<double> logarithmic_grid(double from, double to, int points);

}  // namespace ashimpact
