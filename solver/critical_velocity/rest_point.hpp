#pragma once

#include "solver/critical_velocity/backward_orbit.hpp"

namespace ashimpact {

/// The critical orbit just before an end of contact that is a rest point of the regularised motion
/// (delta'(q_end) = 0: zero overlap of DMT and Brach-Dunn, the pull-off fold of JKR).
///
/// With z = sqrt(q - q_end) and w = |v| it leaves backward along
///
///     w^2/2 = U_end - U + integral of 2 z delta' eta w dz,
///
/// whose solution is a power series in z for every law (q_end - q, its square root or both appear). The
/// series gives speed, work of damping and the time integral of 2 z delta'/w dz up to the end, each to
/// rounding.
[[nodiscard]] Arrival arrival_at_rest_point(const Motion<Extended>& motion);

}  // namespace ashimpact
