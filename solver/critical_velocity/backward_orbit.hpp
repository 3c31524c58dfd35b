// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/motion/motion_stepper.hpp"
#include "solver/numeric/extended.hpp"

namespace ashimpact {

/// Where a critical orbit is followed backward from: at, or just before, the end of contact.
struct Arrival {
    MotionState<Extended> state;
    Extended dissipated_after = 0;           ///< work of damping from that state to the end
    std::optional<Extended> time_after = 0;  ///< from that state to the end; none if infinite
};

/// Whether the end of contact is a rest point of the regularised motion (delta'(q_end) = 0).
[[nodiscard]] bool ends_at_rest_point(const Motion<Extended>& motion);

/// The orbit that arrives at the end of contact with no velocity left; none if no orbit does. Without
/// adhesion there is one only if the damping does not vanish with the contact radius.
[[nodiscard]] std::optional<Arrival> critical_arrival(const Motion<Extended>& motion);

/// Follows the outward leg backward in time to its turning point; none if the orbit escapes, so that no
/// velocity is high enough to rebound. @p steps counts Taylor steps. @throws ConvergenceError
[[nodiscard]] std::optional<MotionState<Extended>> back_to_turn(const Motion<Extended>& motion,
                                                                MotionState<Extended> state, int& steps);

/// Follows the inward leg backward in time to the coordinate @p target. @throws ConvergenceError
[[nodiscard]] MotionState<Extended> back_to(const Motion<Extended>& motion, MotionState<Extended> state,
                                            Extended target, int& steps);

}  // namespace ashimpact
