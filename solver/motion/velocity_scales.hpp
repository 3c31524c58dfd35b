// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Velocity at which constant damping is of order one, beta = 1: eta^5/(m^3 k^2); 0 for other damping laws
/// [m/s].
[[nodiscard]] double velocity_of_damping(const Damping& damping, const ContactPair& contact);

/// Velocity at which the law's adhesion number is one; 0 for a law or a pair without adhesion [m/s].
[[nodiscard]] double velocity_of_adhesion(Law law, const ContactPair& contact);

/// Yield velocity V_y of an undamped Hertz impact: (1/2) m V_y^2 is the elastic energy when the centre
/// reaches p_y; for a sphere (pi^2/sqrt40) (p_y^5/(E*^4 rho))^(1/2), Thornton & Ning 1998. Infinite without a
/// yield pressure [m/s].
[[nodiscard]] double yield_velocity(const ContactPair& contact);

}  // namespace ashimpact
