#pragma once

#include "solver/uncertainty/curve/curve_posterior.hpp"
#include "solver/uncertainty/interval.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

/// v_c and the curve of damping that impacts support, whatever its form.
struct CurveEstimate {
    Interval critical_velocity;  ///< median and 95 % interval [m/s]
    Interval critical_damping;   ///< eta_capture at those [kg/s]
    CurvePosterior::Vector parameters;  ///< of the likeliest curve
    double roughness;                   ///< its smoothness
    Scatter scatter;
    double fastest;  ///< ln v
};

/// The marginal posterior of ln v_c: at each of its values the other parameters are at their most likely and
/// integrated by Laplace's method (Tierney and Kadane 1986), and four degrees of smoothness are averaged with
/// the weights that the impacts give them.
/// @throws ConvergenceError
[[nodiscard]] CurveEstimate estimate_curve(const RestitutionTable& table,
                                           const std::vector<RecordedImpact>& impacts, const CurvePrior& prior,
                                           const std::vector<double>& starts);

}  // namespace ashimpact
