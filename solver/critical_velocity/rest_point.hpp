// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/critical_velocity/backward_orbit.hpp"

namespace ashimpact {

/// The critical orbit just before an end of contact that is a rest point of the regularised motion
/// (delta'(q_end) = 0: zero overlap of DMT, Brach-Dunn and sjkr, the pull-off fold of JKR).
///
/// With z = sqrt(q - q_end) and the speed v it leaves backward along
///
///     v^2/2 = U_end - U + integral of 2 z delta' eta v dz,
///
/// whose solution is a power series in z for every law. Damping may be of the leading order, as in sjkr,
/// whose attraction vanishes as the overlap does. The series gives, each to rounding, the speed, and from it
/// the work of damping and the time up to the end. The time is the integral of 2 z delta'/v dz, none if it
/// diverges.
[[nodiscard]] Arrival arrival_at_rest_point(const Motion<Extended>& motion);

}  // namespace ashimpact
