// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// What the chemistry of the glass changes, for each sample of a run in its order; none for samples without
/// oxides. The dynamic critical velocity is that at the critical damping of the run: where the damping is
/// read again from measured impacts, it stays.
/// @param run with all results but the comparison
/// @param reported of each sample
[[nodiscard]] std::vector<std::optional<GlassEffect>> glass_effects(
    const Run& run, const std::vector<SampleComparison>& reported);

}  // namespace ashimpact
