// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/inference/curve/curve_posterior.hpp"
#include "solver/statistics/intervals/interval.hpp"

namespace ashimpact {

/// v_c and the curve of damping, estimated from all impacts without assuming a form of eta.
struct CurveEstimate {
    Interval critical_velocity;         ///< median and 95 % interval [m/s]
    Interval critical_damping;          ///< eta_capture at those [kg/s]
    CurvePosterior::Vector parameters;  ///< of the likeliest curve
    double effective;                   ///< effective number of independent draws from the posterior
    Scatter scatter;
    double fastest;  ///< ln v_in of the fastest impact
};

/// Samples the posterior of the curve by adaptive importance sampling (Cornuet et al. 2012, Scand. J. Stat.
/// 39:798): draws come from normal densities, each fitted to the draws before. The first densities stand at
/// the modes that are found from @p starts [m/s].
/// @throws ConvergenceError
[[nodiscard]] CurveEstimate estimate_curve(const CurveTable& table,
                                           const std::vector<RecordedImpact>& impacts,
                                           const CurvePrior& prior, const std::vector<double>& starts);

}  // namespace ashimpact
