// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// Standard uncertainty of the difference of two estimates from the same impacts, which share most of their
/// errors. If one of them is efficient, the variance of the difference is the difference of the variances
/// (Hausman 1978). As neither quite is, at least a quarter of the larger variance is taken.
[[nodiscard]] double shared_difference(double one, double other);

/// Whether the paper's extrapolation and the estimate from all impacts agree.
struct FitComparison {
    double critical_damping_ratio;   ///< of the estimate to the extrapolated [1]
    double critical_velocity_ratio;  ///< [1]
    bool consistent;           ///< whether they differ by no more than estimates from the same impacts may
    bool exclude_one_another;  ///< the negation of consistent
    std::string statement;     ///< in words
};
[[nodiscard]] FitComparison compare(const DampingCurveFit& extrapolated, const Interval& critical_velocity,
                                    const Interval& critical_damping);

/// Checks that a fitted v_c does not lie above clear rebounds among the impacts it was fitted to.
///
/// A rebound is clear if v_r exceeds three standard uncertainties of the fit, which may have enlarged or
/// estimated them. The slowest of many rebounds is likely to have a large error of v_in, which is allowed
/// for. Outliers of a robust fit (weight below 0.5) and rebounds that no damping gives do not count.
/// @throws InputError if the lower end of the interval of v_c lies above that
void require_rebounds_above(const DampingCurveFit& fit, const MeasurementSet& set);

}  // namespace ashimpact
