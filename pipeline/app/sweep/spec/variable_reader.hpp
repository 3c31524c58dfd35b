// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "pipeline/app/sweep/spec/inputs.hpp"
#include "solver/statistics/distribution.hpp"

namespace ashimpact {

/// Reads how an input varies: {"values"}, {"grid"} or {"distribution"}, and checks that all of it is
/// admissible.
/// @throws InputError with the JSON pointer
[[nodiscard]] Distribution read_variable(const View& node, ImpactInput input, DampingLaw damping_law);

}  // namespace ashimpact
