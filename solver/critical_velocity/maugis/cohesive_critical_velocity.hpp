// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/maugis/cohesive_motion.hpp"

namespace ashimpact {

/// The Maugis-Dugdale impact that arrives at the end of contact with no velocity left; units of Maugis,
/// mass 1.
struct CriticalCohesiveImpact {
    Extended velocity = 0;      ///< v_c
    Extended dissipated = 0;    ///< work of damping
    Extended break_energy = 0;  ///< U(end) - U(begin), what both jumps cost
    Extended contact_time = 0;
    Extended maximum_overlap = 0;
    int steps = 0;
};

/// Follows that impact backward from its end; none where the orbit escapes, so that every velocity is
/// captured. Requires an end at which a contact can come to rest: U(end) above the potential of static
/// equilibrium.
/// @throws ConvergenceError if the step count runs away
[[nodiscard]] std::optional<CriticalCohesiveImpact> critical_cohesive_impact(const CohesiveMotion& motion);

}  // namespace ashimpact
