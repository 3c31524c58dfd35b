#pragma once

#include "solver/uncertainty/interval.hpp"
#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"

#include <string>

namespace ashimpact {

/// Standard uncertainty of the difference of two estimates from the same impacts. They share most of their
/// errors: of two efficient estimates the difference has the difference of the variances (Hausman 1978). As
/// none is quite efficient, a quarter of the larger variance is the least.
[[nodiscard]] double shared_difference(double one, double other);

/// What the paper's extrapolation and the estimate that the impacts support say of one another.
struct FitComparison {
    double critical_damping_ratio;   ///< of the estimate to the extrapolated [1]
    double critical_velocity_ratio;  ///< [1]
    bool consistent;                 ///< they differ by no more than two estimates of the same impacts do
    bool exclude_one_another;        ///< the opposite
    std::string statement;           ///< in words
};
[[nodiscard]] FitComparison compare(const DampingCurveFit& extrapolated, const Interval& critical_velocity,
                                    const Interval& critical_damping);

}  // namespace ashimpact
