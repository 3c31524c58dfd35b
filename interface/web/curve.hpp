#pragma once

#include "pipeline/json/document.hpp"

namespace ashimpact {

/// Restitution at velocities [m/s] and the critical velocity of one contact. Keys as the options of
/// `ashimpact critical-velocity` (`law`, `diameter`, `density`, `damping`, ...), numbers in SI, `velocities`, and, if
/// the damping is not the same at all of them, `dampings`; the critical velocity is that of `damping`.
/// @return `restitution`, `critical_velocity` (null if there is none), `always_captured`
[[nodiscard]] Json curve_json(const Json& contact);

}  // namespace ashimpact
