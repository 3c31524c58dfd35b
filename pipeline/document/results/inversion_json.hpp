// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/document.hpp"
#include "pipeline/run/results/damping.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// The impacts of a series as columns: the rebounds within reach with number (from 1 on), velocity,
/// restitution, greatest_restitution, damping, its uncertainty where known, and contact_time; captures under
/// captured_at with the least damping that captures; the rest under unreachable.
[[nodiscard]] Json inversion_json(const DampingSeries& series, DampingLaw damping_law);

/// The parts of eta(v_in) between their boundary velocities, numbers of the outliers, and why there are none.
[[nodiscard]] Json parts_json(const DampingSeries& series);

/// Where restitution rises with velocity: up to a velocity, beyond which it falls or the data end.
[[nodiscard]] Json rising_branch_json(double upper, bool falls_beyond);

}  // namespace ashimpact
