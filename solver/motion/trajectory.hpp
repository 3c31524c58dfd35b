// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/motion/impact.hpp"

namespace ashimpact {

/// One instant of an impact; forces positive where they push the bodies apart.
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

}  // namespace ashimpact
