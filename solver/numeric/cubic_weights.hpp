// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace ashimpact {

/// Weights of four evenly spaced values in the cubic interpolation of Catmull and Rom (1974), between the
/// second and the third of them. @param t distance from the second value, in steps [0, 1]
[[nodiscard]] constexpr std::array<double, 4> cubic_weights(double t) {
    return {((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0, ((-1.5 * t + 2.0) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t};
}

/// Derivatives of cubic_weights(), per step.
[[nodiscard]] constexpr std::array<double, 4> cubic_weight_slopes(double t) {
    return {(-1.5 * t + 2.0) * t - 0.5, (4.5 * t - 5.0) * t, (-4.5 * t + 4.0) * t + 0.5, (1.5 * t - 1.0) * t};
}

}  // namespace ashimpact
