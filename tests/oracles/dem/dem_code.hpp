// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/dem/program.hpp"
#include "tests/oracles/time_domain.hpp"

namespace ashimpact::oracles {

/// How an installed DEM code is told about an impact.
struct DemCode {
    struct Setup {
        std::string
            deck;  ///< template; it prints position and velocity of a sphere that touches at 0, moving down
        DeckValues values;  ///< all but those of the schedule
    };

    std::string name;
    std::string program;
    std::string debian_package;
    std::function<bool(const Impact&)> covers;
    std::function<Setup(const Impact&)> setup;
};

/// Hertz and DMT on a wall; JKR as a pair of spheres, ending load-controlled.
DemCode lammps();

/// Hertz and DMT on a wall.
DemCode liggghts();

/// Impacts by a DEM code, extrapolated to time step zero from five steps.
///
/// Velocity Verlet takes the damping at the half-step velocity, so a damped run is of first order, an
/// undamped one of second. On top, the force of Hertz and DMT goes like overlap^1.5 where contact begins and
/// ends, which puts half powers from h^2.5 on into the error, with a coefficient that depends on where
/// between two steps the contact ends. So three coarse runs find how the contact time depends on the step,
/// and the five steps are then chosen such that every contact ends in the middle of a step: only then are the
/// half powers there to be extrapolated away.
/// @throws std::runtime_error if an impact is a capture, or the code fails
std::vector<OracleResult> dem_impacts(const DemCode& code, std::span<const Impact> impacts);

/// Tells rebound (true) from capture by one finely stepped run each.
std::vector<bool> dem_rebounds(const DemCode& code, std::span<const Impact> impacts);

}  // namespace ashimpact::oracles
