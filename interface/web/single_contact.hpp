// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/document.hpp"

namespace ashimpact {

/// One impact, as `ashimpact impact --json`. Keys as the options of that command (`law`, `radius`, `mass`,
/// `damping`, ...), numbers in SI.
[[nodiscard]] Json single_impact_json(const Json& contact);

/// Restitution at velocities [m/s] and the critical velocity of one contact. Keys as above, but
/// `velocities` for `velocity`, and, if the damping is not the same at all of them, `dampings`. Between the
/// velocities, which then have to increase, the damping is taken as linear and beyond them as constant; the
/// critical velocity is where restitution leaves zero on this course.
/// Without `damping` a guess replaces it, whose scaled coefficient is 1 at 1 m/s.
/// @return `restitution`, `critical_velocity` (null if there is none), `always_captured`, `damping`
[[nodiscard]] Json curve_json(const Json& contact);

/// The registered laws: `laws`, by name `title`, `by_default` (of a case that names none) and `parameters`,
/// each with `name`, `unit` (SI), `description`, `example` and `choice` (one of those with the same number,
/// not 0, is given); `damping_laws`, by name the `unit` (SI) of the coefficient.
[[nodiscard]] Json laws_json();

}  // namespace ashimpact
