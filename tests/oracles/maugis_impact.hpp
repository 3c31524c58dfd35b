// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/contact/detachment.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact::oracles {

/// One Maugis-Dugdale impact in the units of Maugis, mass 1.
struct MaugisCase {
    double lambda;           ///< transition parameter
    DampingLaw damping_law;  ///< acts only where the spheres touch
    double damping;          ///< eta, eta/a or eta/sqrt(a)
    double velocity;         ///< where the surfaces come into reach
    ashimpact::Detachment detachment = ashimpact::Detachment::pull_off;
};

struct MaugisResult {
    bool rebound = false;
    double restitution = 0;
    std::optional<double> contact_time{};
    double maximum_overlap = 0;
};

/// Integrates the impact in overlap and velocity over time with GSL (Prince-Dormand 8(9), relative 1e-13).
///
/// The contact force solves Maugis' equations as printed, in m = c/a, for the overlap at hand; the solver's
/// own angle, series and potentials are not used. Turning point, join and break fall on the end of an
/// integration with another clock (Henon, Physica D 5 (1982) 412), in which the fold and the join are smooth.
/// @throws ConvergenceError where GSL gives up
[[nodiscard]] MaugisResult maugis_impact(const MaugisCase& impact);

/// The work lost in both jumps without damping, W in units of Maugis, as the integral of -F over the overlap
/// from the fold to -h_0.
[[nodiscard]] double maugis_separation_energy(double lambda);

}  // namespace ashimpact::oracles
