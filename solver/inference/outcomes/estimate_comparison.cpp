// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/outcomes/estimate_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace ashimpact {

double shared_difference(double one, double other) {
    const double more = std::max(one * one, other * other);
    const double less = std::min(one * one, other * other);
    return std::sqrt(std::max(more - less, 0.25 * more));
}

FitComparison compare(const DampingCurveFit& extrapolated, const Interval& critical_velocity,
                      const Interval& critical_damping) {
    // In logarithms, in which both are closer to normal; 3.5 leaves room for tails that are not.
    constexpr double limit = 3.5;
    const Interval& other = extrapolated.critical_velocity;
    FitComparison result{};
    result.critical_damping_ratio = critical_damping.value / extrapolated.critical_damping.value;
    result.critical_velocity_ratio = critical_velocity.value / other.value;
    const double allowed =
        limit * shared_difference(critical_velocity.standard_uncertainty / critical_velocity.value,
                                  other.standard_uncertainty / other.value);
    result.consistent = std::abs(std::log(result.critical_velocity_ratio)) <= allowed ||
                        critical_velocity.contains(other.value);
    result.exclude_one_another = !result.consistent;
    result.statement = "critical velocity of the estimate over that of the extrapolation: " +
                       shortest(std::round(1e4 * result.critical_velocity_ratio) / 1e4);
    if (result.consistent) {
        result.statement += "; they agree, as far as two estimates from the same impacts can tell";
    } else {
        result.statement += "; they disagree: a damping of order " +
                            std::to_string(extrapolated.options.order) +
                            " in the restitution does not describe these impacts down to capture";
    }
    return result;
}

}  // namespace ashimpact
