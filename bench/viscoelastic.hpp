// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/measured.hpp"

namespace ashimpact::bench {

/// Restitution of viscoelastic spheres by the Pade approximants with which event-driven codes replace the
/// integration (Mueller & Poeschel 2011): Hertz with contact-radius damping, in contact until the force
/// vanishes. v* is the root of the damping number, so that v* = sqrt(beta) v^(1/10) for a given pair.

/// Of degrees 1 and 4. @param velocity_star v* >= 0 [1]. Restitution [1].
[[nodiscard]] double pade_1_4(double velocity_star);
/// Of degrees 3 and 6. @param velocity_star v* >= 0 [1]. Restitution [1].
[[nodiscard]] double pade_3_6(double velocity_star);

/// Prints rates and errors of both and of ashimpact, for the same impacts.
/// @param unit rate that rates are divided by [1/s]
void print_viscoelastic(const Options& options, double unit);

}  // namespace ashimpact::bench
