// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::test {

/// A way to run an impact.
struct ContactCase {
    Law law;
    DampingLaw damping_law;
    Detachment detachment;
    double yield_pressure = std::numeric_limits<double>::infinity();  ///< [Pa]
};

/// Every registered law with every damping law and every detachment that is admissible for it, its contact
/// never yielding: no law has a memory then.
[[nodiscard]] std::vector<ContactCase> elastic_cases();

/// Those of the laws that have a memory, with a contact that yields in most impacts of ash().
[[nodiscard]] std::vector<ContactCase> yielding_cases();

/// Both.
[[nodiscard]] std::vector<ContactCase> contact_cases();

/// The elastic ones without damping laws: constant represents all of them.
[[nodiscard]] std::vector<ContactCase> undamped_cases();

/// "dmt, tsuji, zero-overlap"; "..., yielding".
[[nodiscard]] std::string name_of(const ContactCase& c);

/// A value of every parameter that a law must be given: typical ones, but in proportion to @p
/// work_of_adhesion (typical at 0.3 J/m2) for laws whose attraction comes from their parameters alone.
[[nodiscard]] ParameterValues<double> parameters_like(double work_of_adhesion);

/// The sphere of the reference impacts (88 um, 2600 kg/m3) on its wall, E* = 90 GPa, with parameters_like().
[[nodiscard]] ContactPair ash(double work_of_adhesion);

/// A sphere anywhere in the range that fly ash and its neighbours span, with parameters_like().
[[nodiscard]] ContactPair random_pair(Random& random);

/// Works of adhesion, velocities and scaled dampings that span the reference impacts [J/m2], [m/s], [1].
inline constexpr double ash_adhesions[] = {0.05, 0.3, 1.0};
inline constexpr double ash_velocities[] = {0.5, 2.0, 10.0};
inline constexpr double damping_numbers[] = {0.05, 0.3, 0.8};

/// An impact whose damping has the scaled value @p damping_number at that velocity (beta for constant
/// damping), and whose contact has the case's yield pressure.
[[nodiscard]] Impact impact_of(const ContactCase& c, const ContactPair& pair, double damping_number,
                               double velocity);

/// solve_impact() and critical_velocity(); what they throw is reported with the impact.
[[nodiscard]] ImpactResult solved(const Impact& impact);
[[nodiscard]] CriticalVelocity critical_of(const Impact& impact);

/// The impact in words, for the message of a failed check.
[[nodiscard]] std::string describe(const Impact& impact);

}  // namespace ashimpact::test
