// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace ashimpact::oracles {

enum class Law { hertz, dmt, brach_dunn, jkr };
enum class Detachment { zero_overlap, zero_force, pull_off, load_controlled };

/// One normal impact of a sphere on a flat wall: m x'' + damping x' + F(x) = 0 from first touch, x'(0) =
/// velocity.
struct ImpactCase {
    Law law;
    Detachment detachment;
    double radius;            ///< of the sphere, which is the effective radius of the contact [m]
    double mass;              ///< [kg]
    double contact_modulus;   ///< E* [Pa]
    double work_of_adhesion;  ///< w, of the pair of surfaces: twice the surface energy of each [J/m2]
    double damping;           ///< constant, of the total normal velocity [kg/s]
    double velocity;          ///< at first touch, positive [m/s]
};

/// A number with the error its producer claims for it, both in the unit of the quantity.
struct Estimate {
    double value = 0;
    double error = 0;
};

struct ImpactResult {
    bool rebound = false;
    Estimate restitution;      ///< speed at the end of contact over speed at first touch [-]; 0 for a capture
    Estimate contact_time;     ///< first touch to end of contact [s]; 0 for a capture
    Estimate maximum_overlap;  ///< [m]
};

std::string name(Law law);
std::string name(Detachment detachment);
Law law_from(const std::string& name);
Detachment detachment_from(const std::string& name);

/// Returns the mass of a full sphere [kg].
/// @param radius [m]
/// @param density [kg/m3]
double sphere_mass(double radius, double density);

/// Returns the same impact at another velocity [m/s].
ImpactCase at_velocity(ImpactCase impact, double velocity);

/// The impacts on which the oracles are compared: spheres of 5 to 100 um, 1000 to 8000 kg/m3, E* 1 to 200
/// GPa, w 0 to 1 J/m2, 0.3 to 20 m/s, with fly ash (44 to 52 um, about 2400 kg/m3 and 90 GPa) in the middle,
/// and damping from none to nine tenths of what would capture the sphere. All of them rebound.
std::vector<ImpactCase> grid();

/// The same parameters with the laws and ends of contact that no DEM code has: Hertz to zero force,
/// Brach-Dunn in the place of DMT, JKR to the fold and to zero overlap. Some are captures.
std::vector<ImpactCase> grid_beyond_dem_codes();

}  // namespace ashimpact::oracles
