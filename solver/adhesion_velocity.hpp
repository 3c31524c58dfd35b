#pragma once

#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact {

/// Velocity at which the law's adhesion number is one; 0 for a law or a pair without adhesion [m/s].
/// With this as the unit of velocity, an impact with constant damping has two scaled numbers whatever its
/// material: v/(adhesion velocity) and the damping number.
[[nodiscard]] double adhesion_velocity(Law law, const ContactPair& contact);

}  // namespace ashimpact
