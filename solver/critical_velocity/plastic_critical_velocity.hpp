// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

/// The critical velocity of a law with plastic history (ThorntonNing, finite yield pressure).
///
/// The rebound depends on the greatest contact reached. So the first step is to find every greatest contact,
/// up to overlaps of R*, from which unloading arrives at the end of contact at rest; there may be several,
/// since rebound need not be monotone. The second step follows the loading branches backward from there.
/// Verdicts hold for overlaps up to R* only.
/// @throws InputError, ConvergenceError
[[nodiscard]] CriticalVelocity plastic_critical_velocity(const CriticalVelocityProblem& problem);

}  // namespace ashimpact
