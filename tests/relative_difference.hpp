// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace ashimpact::test {

/// |a - b| over the larger magnitude [1]; 0 when both are the same. doctest::Approx adds 1 to the scale, so
/// it lets every number of fly-ash size pass.
[[nodiscard]] inline double relative_difference(double a, double b) {
    if (a == b) return 0;
    return std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

}  // namespace ashimpact::test
