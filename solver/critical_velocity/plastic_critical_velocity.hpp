#pragma once

#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

/// The critical velocity of a law with plastic history (ThorntonNing, finite yield pressure).
///
/// The rebound depends on the greatest contact reached, so it is found in two steps: the greatest contact
/// from which unloading arrives at the end of contact at rest (every one up to overlaps of R*; rebound need
/// not be monotone), then the loading branches backward from there. Verdicts speak of overlaps up to R* only.
/// @throws InputError, ConvergenceError
[[nodiscard]] CriticalVelocity plastic_critical_velocity(const CriticalVelocityProblem& problem);

}  // namespace ashimpact
