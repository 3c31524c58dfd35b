// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>

#include "solver/damping/damping_polynomial.hpp"

namespace ashimpact {

/// One inverted measurement: the damping that gives back a measured restitution.
struct DampingPoint {
    double restitution;           ///< e_n [1]
    double damping;               ///< eta [kg/s]
    double standard_uncertainty;  ///< of the damping [kg/s]; 0 where unknown, then for every point
};

/// eta = a e_n^2 + b e_n + c; Dong et al. 2013, Table 2, section 4.3.
struct DampingFit {
    DampingPolynomial damping;
    Eigen::Matrix3d covariance;  ///< of (c, b, a), the coefficients in ascending powers [kg2/s2]
    double chi_squared;  ///< weighted sum of squared residuals; unweighted [kg2/s2] where uncertainties are
                         ///< unknown
    double residual_deviation;  ///< standard deviation of the residuals [kg/s]
    int degrees_of_freedom;     ///< points - 3
};

/// Least-squares quadratic with covariance (GSL multifit). Where the uncertainties are unknown the covariance
/// is scaled by the scatter of the residuals; with exactly three points it is then zero.
/// @throws InputError for fewer than three distinct restitutions or values that are not finite
[[nodiscard]] DampingFit fit_damping(std::span<const DampingPoint> points);

}  // namespace ashimpact
