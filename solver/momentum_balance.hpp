#pragma once

#include "solver/impact.hpp"

namespace ashimpact {

/// The momentum balance of an impact, Dong et al. 2013, Eqs. 35-45, evaluated instead of argued.
///
/// Impulses are of the total static force F_tot, positive where it pushes the bodies apart, and of the
/// damping force: m v_in = static + damping on approach (Eq. 38), m v_r = static - damping on rebound (Eq.
/// 39). The rebound leg of a captured particle does not exist; its terms are 0 and the verdicts empty.
struct MomentumBalance {
    double approach_time;             ///< t_m [s]
    double rebound_time;              ///< t_n - t_m [s]
    double approach_static_impulse;   ///< [N s]
    double approach_damping_impulse;  ///< integral of eta v dt; eta delta_max for constant damping [N s]
    double rebound_static_impulse;    ///< [N s]
    double rebound_damping_impulse;   ///< magnitude [N s]
    double approach_mean_force;       ///< of F_tot over t_m [N]
    double rebound_mean_force;        ///< of F_tot over t_n - t_m [N]; the paper takes both as equal (Eq. 40)
    double momentum_lost;             ///< m v_in - m v_r, right side of (44) [N s]
    std::optional<bool> inequality_44;  ///< damping impulses > momentum lost
    std::optional<bool> inequality_45;  ///< rebound takes longer than approach
};

/// Evaluates the balance from the solved impact, exactly: the damping impulse is a polynomial of the state.
/// @throws InputError for inadmissible input or an impact that never turns, ConvergenceError
[[nodiscard]] MomentumBalance momentum_balance(const Impact& impact);

}  // namespace ashimpact
