#pragma once

#include "solver/impact.hpp"

namespace ashimpact {

/// Time, impulses and mean static force of one stage of an impact.
struct StageMomentum {
    double duration;         ///< [s]
    double static_impulse;   ///< of the contact force F_tot, positive where it pushes the bodies apart [N s]
    double damping_impulse;  ///< of the damping force, as a magnitude [N s]
    double mean_force;       ///< static_impulse/duration [N]
    double residual;         ///< what does not close: error of the quadrature [N s]
};

/// The momentum of one rebound, stage by stage; Dong et al. 2013, Eqs. 35-45, from the dense trajectory.
///
/// Approach: static + damping impulse = m v_in (Eqs. 36, 38). Rebound: static - damping impulse = m v_rn (37,
/// 39). The paper argues for (44) and (45) from equal mean forces (40) and speeds that fall all the way;
/// neither holds exactly, so both are reported, not presumed.
struct MomentumBalance {
    StageMomentum approach;
    StageMomentum rebound;
    double damping_impulse;  ///< left of (44), 2 eta delta_m for constant damping [N s]
    double momentum_lost;    ///< right of (44), m (v_in - v_rn) [N s]

    [[nodiscard]] bool damping_exceeds_loss() const { return damping_impulse > momentum_lost; }    ///< (44)
    [[nodiscard]] bool rebound_is_longer() const { return rebound.duration > approach.duration; }  ///< (45)
};

/// The balance of an impact that rebounds, by the trapezoidal rule over @p points instants. Forces have
/// half-integer powers of time at touch and detachment (quarter ones with Tsuji's damping), so the error is
/// of order points^(-3/2), or points^(-5/4).
/// @throws InputError for inadmissible input or an impact that ends in capture
[[nodiscard]] MomentumBalance momentum_balance(const Impact& impact, int points = 1001);

}  // namespace ashimpact
