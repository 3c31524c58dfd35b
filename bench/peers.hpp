// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/impact.hpp"

namespace ashimpact::bench {

// Other ways to solve one impact, in time, as one would write them: delta'' = -(F(delta) + eta delta'),
// scaled; at the end of contact overlap becomes the clock, so that detachment is hit exactly. For DMT with
// constant damping that rebounds.

/// GSL's Prince-Dormand pair 8(9), relative tolerance 1e-10. Restitution [1].
[[nodiscard]] double gsl_rk8pd(const Impact& impact);
/// Boost.odeint, Fehlberg 7(8), tolerance 1e-7. Restitution [1].
[[nodiscard]] double odeint_fehlberg78(const Impact& impact);
/// Boost.odeint, Dormand-Prince 5(4), tolerance 1e-7. Restitution [1].
[[nodiscard]] double odeint_dopri5(const Impact& impact);
/// Velocity Verlet, 200 steps a Hertz contact; the end interpolated linearly. Restitution [1].
[[nodiscard]] double velocity_verlet(const Impact& impact);

}  // namespace ashimpact::bench
