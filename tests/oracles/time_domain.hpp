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

/// One impact integrated in time, in overlap and velocity, with GSL (Prince-Dormand 8(9), relative 1e-13).
///
/// Where something happens, the last step is taken again with another clock, so that the event falls on the
/// end of an integration and is as exact as the rest (Henon, Physica D 5 (1982) 412): the velocity for the
/// turning point, the root of the overlap left for the end of contact (which also takes away the JKR fold's
/// singularity), the net force for zero_force. A rebound that turns before the end is a capture; so is one
/// that takes longer than 400 Hertz times.
/// @throws ConvergenceError where GSL gives up
OracleResult time_domain_impact(const Impact& impact);

/// Returns the velocity [m/s] that parts capture from rebound, by bisection to a relative 1e-9.
/// @throws ConvergenceError where no velocity below 1e3 m/s rebounds, or all above 1e-6 m/s do
double time_domain_critical_velocity(const Impact& impact);

/// The contact laws as force against overlap, written from the papers for the oracles alone. Repulsion is
/// positive.
///
/// Hertz k x^1.5, k = (4/3) E* sqrt(R); DMT (1975) the same less 2 pi w R; Brach and Dunn (1992) less 2 pi a
/// f, a = sqrt(R x), f = (6 w^2 R E* / pi)^(1/3); JKR (1971) (4/3) E* a^3 / R - sqrt(8 pi w E* a^3) with a
/// from x = a^2 / R - sqrt(2 pi w a / E*), the stable branch.
class ContactForce {
  public:
    explicit ContactForce(const Impact& impact);

    /// Returns the force [N] at an overlap [m]; beyond the end of the law it keeps its last value.
    [[nodiscard]] double operator()(double overlap) const;

    /// Returns dF/dx [N/m] of the Hertzian part k x^1.5.
    [[nodiscard]] double hertz_slope(double overlap) const;

    /// Returns the overlap [m] below which there is no contact; zero_force ends earlier, by force.
    [[nodiscard]] double end_overlap() const { return end_overlap_; }

    /// Returns the overlap [m] and time [s] of an undamped Hertz impact, the scale of everything that
    /// happens: x0 = (m v^2 / k)^(2/5) and x0 / v.
    [[nodiscard]] double overlap_scale() const { return overlap_scale_; }
    [[nodiscard]] double time_scale() const { return time_scale_; }

  private:
    [[nodiscard]] double jkr_force(double overlap) const;
    [[nodiscard]] double jkr_contact_radius(double overlap) const;

    Law law_;
    double radius_;
    double contact_modulus_;
    double work_of_adhesion_;
    double stiffness_;      // k [N/m^1.5]
    double constant_pull_;  // DMT [N]
    double radius_pull_;    // Brach-Dunn, per sqrt(overlap) [N/m^0.5]
    double stretch_;        // JKR, sqrt(2 pi w / E*) [m^0.5]
    double fold_overlap_;   // JKR, the least overlap of the stable branch [m]
    double end_overlap_;    // [m]
    double overlap_scale_;  // [m]
    double time_scale_;     // [s]
};

}  // namespace ashimpact::oracles
