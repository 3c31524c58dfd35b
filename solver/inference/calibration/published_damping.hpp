// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Dense>

#include "solver/damping/damping_polynomial.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// A published critical velocity, with the critical damping it was computed from (Tables 3 and 4).
struct CriticalVelocityObservation {
    std::size_t sample;
    Law law;
    double critical_damping;              ///< eta_c [kg/s]
    double critical_damping_uncertainty;  ///< standard, e.g. rounding/sqrt(12) [kg/s]
    double value;                         ///< v_c [m/s]
    double standard_uncertainty;          ///< of v_c itself [m/s]
};

/// A published contact time at a velocity where the damping is known through a fit eta(e_n) (Table 2).
struct ContactTimeObservation {
    std::size_t sample;
    Law law;
    DampingPolynomial damping_fit;  ///< of the second order [kg/s]
    double velocity;                ///< v_in [m/s]
    double velocity_uncertainty;    ///< standard [m/s]
    double value;                   ///< contact time [s]
    double standard_uncertainty;    ///< of the time itself [s]
    /// Standard uncertainty of each coefficient, e.g. rounding/sqrt(12) [kg/s]. The error of c and that of
    /// critical_damping of the same sample and law are one, since one printed number gives both.
    double damping_fit_uncertainty = 0.0;
};

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

/// What the paper's scheme at a finite step makes of an exact impact, to first order in the step. Eq. 31
/// takes the damping force half a step late, eta (v - a Dt/2), which is an impact of mass m (1 - lag) with
/// lag = eta Dt/(2 m). It starts from delta_1 = v Dt, so that the velocity is v half a step after first
/// touch: the impact begins with v (1 + lag). solve_impact_explicit() is the scheme itself.
struct FiniteStep {
    double time_step = 0.0;  ///< Dt; 0: exact impacts [s]

    [[nodiscard]] double lag(double damping, const ContactPair& contact) const {
        return damping * time_step / (2.0 * contact.mass);
    }
    /// The contact of the exact impact that takes the place of one of the scheme.
    [[nodiscard]] ContactPair contact(double damping, ContactPair contact) const {
        contact.mass *= 1.0 - lag(damping, contact);
        return contact;
    }
};

/// A particle and law whose measured restitution is known only through a published fit eta(e_n).
struct PublishedDamping {
    Law law;
    Detachment detachment;
    ContactPair contact;
    DampingPolynomial damping;  ///< eta(e_n), constant during an impact [kg/s]
    FiniteStep step{};          ///< with which it was computed

    /// The impact of damping eta(@p e) at a velocity [m/s].
    [[nodiscard]] Impact impact(double e, double velocity) const {
        return {law,
                detachment,
                {DampingLaw::constant, damping(e)},
                step.contact(damping(e), contact),
                velocity * quickening(e)};
    }
    /// By how much impact() begins faster than the velocity it was given [1].
    [[nodiscard]] double quickening(double e) const { return 1.0 + step.lag(damping(e), contact); }
};

/// The incident velocity at which an impact with this damping rebounds with restitution @p restitution [m/s].
/// Restitution rises monotonically with velocity for constant damping, unless the contact yields.
/// @param impact its velocity is not used
/// @throws InputError for another damping law, a restitution outside (0, 1) or not reached at any velocity
[[nodiscard]] double velocity_of_restitution(const Impact& impact, double restitution);

/// The velocity at which an impact with damping eta(e) has restitution @p e [m/s]: one point of the curve
/// e_n(v_in) that a published fit implies. Reconstructed, not measured: label it so. Each restitution has one
/// velocity; a velocity may have two restitutions, see least_rebound().
[[nodiscard]] double reconstructed_velocity(const PublishedDamping& published, double e);

/// A point of a reconstructed curve.
struct CurvePoint {
    double velocity;     ///< [m/s]
    double restitution;  ///< [1]
};

/// The rebound of least velocity on the curve: where its rising branch begins.
///
/// For adhesive laws the curve folds there. eta falls with e, and with it v_c(eta), in proportion to e. At
/// fixed eta a rebound e needs only a share of order e^2 more than v_c. So from (v_c, 0) the curve first runs
/// back to lower velocities (Brach-Dunn, 88 um: by 0.85 %), and rises from the fold on. No measurement shows
/// the part below the fold, where e falls with velocity.
///
/// For Hertz it folds only if eta falls by more than 4.283 of itself per unit of e (docs/dong2013.md). The
/// paper's fits fall by 1.9 at most, so that their rising branch begins at v_c with e = 0.
[[nodiscard]] CurvePoint least_rebound(const PublishedDamping& published);

/// Restitution of the curve at @p velocity [m/s]: the least one on the rising branch; 0 below the velocity of
/// least_rebound() [1].
[[nodiscard]] double reconstructed_restitution(const PublishedDamping& published, double velocity);

}  // namespace ashimpact
