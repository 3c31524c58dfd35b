// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "tests/oracles/dem/dem_code.hpp"

namespace ashimpact::oracles {

/// Impacts by a DEM code, extrapolated to time step zero from five steps.
///
/// Velocity Verlet takes the damping at the half-step velocity, so a damped run is of first order, an
/// undamped one of second. On top, the force of Hertz and DMT goes like overlap^1.5 where contact begins and
/// ends, which puts half powers from h^2.5 on into the error, with a coefficient that depends on where
/// between two steps the contact ends. So three coarse runs find how the contact time depends on the step,
/// and the five steps are then chosen such that every contact ends in the middle of a step: only then are the
/// half powers there to be extrapolated away.
/// @throws std::runtime_error if an impact is a capture, or the code fails
std::vector<ImpactResult> dem_impacts(const DemCode& code, std::span<const ImpactCase> impacts);

/// Tells rebound (true) from capture by one finely stepped run each.
std::vector<bool> dem_rebounds(const DemCode& code, std::span<const ImpactCase> impacts);

}  // namespace ashimpact::oracles
