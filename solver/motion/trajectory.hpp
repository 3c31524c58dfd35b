// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/motion/impact.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// One instant of an impact; forces positive where they push the bodies apart. The static force is parted as
/// the damping laws part it: repulsion is its Hertzian part, of JKR K a^3/R*, attraction the rest.
struct TrajectoryPoint {
    double time;              ///< since first touch [s]
    double overlap;           ///< [m]
    double velocity;          ///< d(delta)/dt, positive on approach [m/s]
    double contact_radius;    ///< [m]
    double repulsive_force;   ///< F_r [N]
    double attractive_force;  ///< F_a, never positive [N]
    double damping_force;     ///< eta d(delta)/dt, opposing the motion [N]
};

/// The impact at @p count instants evenly spaced in time from first touch to detachment, exact to the
/// solver's tolerance at each of them. A capture is followed until the particle rests to 1 % of v_in or has
/// @p count points of ringing.
/// @throws InputError for inadmissible input or count < 2
[[nodiscard]] std::vector<TrajectoryPoint> trajectory(const Impact& impact, int count);

/// Time, impulses and mean static force of one stage of an impact.
struct StageMomentum {
    double duration;         ///< [s]
    double static_impulse;   ///< of the contact force F_tot, positive where it pushes the bodies apart [N s]
    double damping_impulse;  ///< of the damping force, as a magnitude [N s]
    double mean_force;       ///< static_impulse/duration [N]
    double residual;         ///< error of the quadrature: what is missing in the momentum balance [N s]
};

/// The momentum of one rebound, stage by stage; Dong et al. 2013, Eqs. 35-45.
///
/// Approach: static + damping impulse = m v_in (Eqs. 36, 38). Rebound: static - damping impulse = m v_rn (37,
/// 39). The paper derives (44) and (45) from equal mean forces (40), |v| <= v_in on approach and |v| <= v_rn
/// on rebound. None of these holds exactly, so the balance reports both sides.
struct MomentumBalance {
    StageMomentum approach;
    StageMomentum rebound;
    double incident_momentum;  ///< m v_in [N s]
    /// Left side of (44) [N s]: the damping impulse, as a magnitude. Constant damping gives 2 eta delta_m if
    /// the contact ends at zero overlap, eta (2 delta_m - delta_f) if it ends at overlap delta_f, which is
    /// negative on the neck of a JKR contact, positive at zero force with adhesion.
    double damping_impulse;
    double momentum_lost;  ///< right side of (44), m (v_in - v_rn) [N s]

    /// Sides that differ by rounding only, as without damping, count as equal.
    [[nodiscard]] bool damping_exceeds_loss() const;  ///< (44)
    [[nodiscard]] bool rebound_is_longer() const;     ///< (45)
    /// Mean static force of the rebound over that of the approach; the paper takes it for 1 (40) [1].
    [[nodiscard]] double mean_force_ratio() const { return rebound.mean_force / approach.mean_force; }
};

/// Both sides of (40), (44) and (45), as text.
[[nodiscard]] std::string verdict_of(const MomentumBalance& balance);

/// The balance of an impact that rebounds: forces integrated over the solver's own dense output by
/// Gauss-Legendre quadrature, step by step, so that residuals are of the order of rounding.
/// @throws InputError for inadmissible input or an impact that ends in capture
[[nodiscard]] MomentumBalance momentum_balance(const Impact& impact);

/// Time integral of |F_a| from first touch to detachment of an impact that rebounds [N s], F_a as in a
/// trajectory: how much more the surfaces push than the momentum of the sphere changes.
/// @param precision of a cohesive zone, which takes three times as long in the extended one
/// @throws as momentum_balance()
[[nodiscard]] double attraction_impulse(const Impact& impact, Precision precision = Precision::extended);

}  // namespace ashimpact
