// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

/// The impacts on which the oracles are compared: spheres of 5 to 100 um, 1000 to 8000 kg/m3, E* 1 to 200
/// GPa, w 0 to 1 J/m2, 0.3 to 20 m/s, with fly ash (44 to 52 um, about 2400 kg/m3 and 90 GPa) in the middle,
/// and damping from none to nine tenths of what would capture the sphere. All of them rebound.
std::vector<ImpactCase> grid();

/// The same parameters with the laws and ends of contact that no DEM code has: Hertz to zero force,
/// Brach-Dunn in the place of DMT, JKR to the fold and to zero overlap. Some are captures.
std::vector<ImpactCase> grid_beyond_dem_codes();

}  // namespace ashimpact::oracles
