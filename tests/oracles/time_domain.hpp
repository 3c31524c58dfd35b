// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

/// One impact integrated in time, in overlap and velocity, with GSL (Prince-Dormand 8(9), relative 1e-13).
///
/// Where something happens, the last step is taken again with another clock, so that the event falls on the
/// end of an integration and is as exact as the rest (Henon, Physica D 5 (1982) 412): the velocity for the
/// turning point, the root of the overlap left for the end of contact (which also takes away the JKR fold's
/// singularity), the net force for zero_force. A rebound that turns before the end is a capture; so is one
/// that takes longer than 400 Hertz times.
/// @throws ConvergenceError where GSL gives up
ImpactResult time_domain_impact(const ImpactCase& impact);

/// Returns the velocity [m/s] that parts capture from rebound, by bisection to a relative 1e-9.
/// @throws ConvergenceError where no velocity below 1e3 m/s rebounds, or all above 1e-6 m/s do
double time_domain_critical_velocity(const ImpactCase& impact);

}  // namespace ashimpact::oracles
