#pragma once

#include <array>
#include <span>

namespace ashimpact {

/// One inverted measurement: the damping that gives back a measured restitution.
struct DampingPoint {
    double restitution;           ///< e_n [1]
    double damping;               ///< eta [kg/s]
    double standard_uncertainty;  ///< of the damping [kg/s]; 0 where unknown, then for every point
};

/// eta = a e_n^2 + b e_n + c; Dong et al. 2013, Table 2, section 4.3.
struct DampingFit {
    double a;                                         ///< [kg/s]
    double b;                                         ///< [kg/s]
    double c;                                         ///< [kg/s]
    std::array<std::array<double, 3>, 3> covariance;  ///< of (a, b, c) [kg2/s2]
    double chi_squared;  ///< weighted sum of squared residuals; unweighted [kg2/s2] where uncertainties are
                         ///< unknown
    double residual_deviation;  ///< standard deviation of the residuals [kg/s]
    int degrees_of_freedom;     ///< points - 3

    /// eta at restitution @p e [kg/s].
    [[nodiscard]] double operator()(double e) const { return (a * e + b) * e + c; }
    /// eta_c = eta(0), the critical damping of Table 3 [kg/s].
    [[nodiscard]] double critical_damping() const { return c; }
};

/// Least-squares quadratic with covariance (GSL multifit). Where the uncertainties are unknown the covariance
/// is scaled by the scatter of the residuals; with exactly three points it is then zero.
/// @throws InputError for fewer than three distinct restitutions or values that are not finite
[[nodiscard]] DampingFit fit_damping(std::span<const DampingPoint> points);

}  // namespace ashimpact
