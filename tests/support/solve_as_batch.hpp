// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/batch/batch.hpp"

namespace ashimpact::test {

/// An impact as a batch of one.
[[nodiscard]] inline ImpactBatchResult solve_as_batch(const Impact& impact,
                                                      const BatchOptions& options = {}) {
    return solve_impacts(ImpactList({impact}).batch(), options);
}

}  // namespace ashimpact::test
