// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/motion/impact.hpp"

namespace ashimpact::oracles {

/// A number with the error its producer claims for it, both in the unit of the quantity.
struct Estimate {
    double value = 0;
    double error = 0;
};

struct OracleResult {
    bool rebound = false;
    Estimate restitution;      ///< speed at the end of contact over speed at first touch [-]; 0 for a capture
    Estimate contact_time;     ///< first touch to end of contact [s]; 0 for a capture
    Estimate maximum_overlap;  ///< [m]
};

/// Returns the same impact at another velocity [m/s].
Impact at_velocity(Impact impact, double velocity);

/// The impacts on which the oracles are compared: spheres of 5 to 100 um, 1000 to 8000 kg/m3, E* 1 to 200
/// GPa, w 0 to 1 J/m2, 0.3 to 20 m/s, with fly ash (44 to 52 um, about 2400 kg/m3 and 90 GPa) in the middle,
/// and damping from none to nine tenths of what would capture the sphere. All of them rebound.
std::vector<Impact> grid();

/// The same parameters with the laws and ends of contact that no DEM code has: Hertz to zero force,
/// Brach-Dunn in the place of DMT, JKR to the fold and to zero overlap. Some are captures.
std::vector<Impact> grid_beyond_dem_codes();

}  // namespace ashimpact::oracles
