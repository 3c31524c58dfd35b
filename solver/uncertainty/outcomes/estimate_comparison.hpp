#pragma once

#include "solver/uncertainty/interval.hpp"
#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"

#include <string>

namespace ashimpact {

/// Standard uncertainty of the difference of two estimates from the same impacts, which share most of their
/// errors. If one is efficient, the variance of the difference is the difference of the variances (Hausman
/// 1978). Neither is quite, so that it is taken as a quarter of the larger variance at least.
[[nodiscard]] double shared_difference(double one, double other);

/// The paper's extrapolation and the estimate from all impacts, compared.
struct FitComparison {
    double critical_damping_ratio;   ///< of the estimate to the extrapolated [1]
    double critical_velocity_ratio;  ///< [1]
    bool consistent;                 ///< they differ by no more than two estimates of the same impacts do
    bool exclude_one_another;        ///< the opposite of consistent
    std::string statement;           ///< in words
};
[[nodiscard]] FitComparison compare(const DampingCurveFit& extrapolated, const Interval& critical_velocity,
                                    const Interval& critical_damping);

}  // namespace ashimpact
