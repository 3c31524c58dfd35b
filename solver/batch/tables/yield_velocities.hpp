// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "solver/batch/problems.hpp"

namespace ashimpact::batch {

enum class PieceState : std::uint8_t;

/// Critical velocities of contacts that may yield, to 1e-9 of critical_velocity(); those in doubt are left
/// undecided.
///
/// Unloading is that of an elastic contact with the flattened sphere's radius, released at rest. So the
/// greatest contact that is just captured follows from a table of one number, as that of the elastic law
/// does. The velocity that leads there is searched by impacts in lanes, many at once.
/// @param problems as many as a task has at most, of a law that has kernels
void find_yield_velocities(const Problems& problems, PieceState* state, double* value);

}  // namespace ashimpact::batch
