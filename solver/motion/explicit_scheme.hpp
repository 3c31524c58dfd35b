// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/impact.hpp"

namespace ashimpact {

struct ExplicitSchemeOptions {
    double time_step = 0.0;         ///< Dt, at most m/eta and a tenth of an undamped Hertz contact [s]
    long most_steps = 100'000'000;  ///< step limit
};

/// Whether the scheme has the law: its force is a function of overlap, from zero overlap on.
[[nodiscard]] bool has_explicit_scheme(Law law);

/// The paper's own scheme, kept as a second method to compare with:
///
///     (delta_i - 2 delta_{i+1} + delta_{i+2})/Dt^2 + eta/m (delta_{i+1} - delta_i)/Dt + F(delta_{i+1})/m = 0
///
/// from delta_0 = 0, delta_1 = v Dt; Dong et al. 2013, Eqs. 31-34. First order in Dt: the damping uses the
/// velocity half a step behind. Validity: constant damping, and laws whose force is a function of overlap
/// (not JKR).
///
/// The contact ends at zero overlap: the crossing is interpolated linearly, the velocity there is that of the
/// last two steps. An impact is captured if it turns a second time, or if CaptureTest finds that it creeps.
/// The ledger ends where that of solve_impact() does; its residual is the energy error of the scheme.
/// @throws InputError for what the scheme cannot treat, ConvergenceError at the step limit
[[nodiscard]] ImpactResult solve_impact_explicit(const Impact& impact, const ExplicitSchemeOptions& options);

/// A time step that gives about @p steps steps in an undamped Hertz contact, and at least 100 in the time
/// m/eta in which damping acts [s].
[[nodiscard]] double explicit_time_step(const Impact& impact, double steps);

/// The velocity that parts captured from rebounding impacts of the scheme, as the paper's Table 4 has it
/// [m/s].
/// @param near an impact with the damping asked about, at a velocity to start from: the exact v_c
/// @throws InputError for what the scheme cannot treat, ConvergenceError where it parts none
[[nodiscard]] double explicit_critical_velocity(const Impact& near, const ExplicitSchemeOptions& options);

/// The damping coefficient whose impact by the scheme has that restitution, section 4.2 of the paper; for 0
/// the smallest that captures [unit of the damping law].
/// @param near the impact with a damping above 0 to start from: the exact one
/// @throws InputError for what the scheme cannot treat, ConvergenceError if no damping is found
[[nodiscard]] double explicit_damping(const Impact& near, double restitution,
                                      const ExplicitSchemeOptions& options);

}  // namespace ashimpact
