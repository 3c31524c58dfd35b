// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/run/stage.hpp"

namespace ashimpact {

/// Compares analytic, dynamic and measured critical velocities, and published values with ours, and states in
/// words what the ratio of dynamic to analytic velocities means.
[[nodiscard]] StageOutput comparison_stage(const Artifacts& before);

}  // namespace ashimpact
