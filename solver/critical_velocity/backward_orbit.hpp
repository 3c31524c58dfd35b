// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/branches/plastic_motion.hpp"
#include "solver/motion/legs.hpp"
#include "solver/numeric/extended.hpp"

namespace ashimpact {

/// An impact that arrives at the end of contact with no velocity left, scaled.
struct CriticalImpact {
    Extended velocity = 0;                 ///< v_c
    Extended dissipated = 0;               ///< work of damping
    Extended plastic = 0;                  ///< work spent in yielding
    Extended break_energy = 0;             ///< U(end) - U(touch), cost of the break
    std::optional<Extended> contact_time;  ///< first touch to arrival at rest; none if infinite
    Extended maximum_overlap = 0;
};

/// The critical impacts of a contact by ascending greatest contact, or the verdict if there is none.
struct CriticalImpacts {
    CaptureVerdict verdict = CaptureVerdict::finite;
    std::vector<CriticalImpact> impacts{};
};

/// Of an elastic contact: one impact, followed backward from the end. @throws ConvergenceError
[[nodiscard]] CriticalImpacts critical_impacts(const Motion<Extended>& motion);

/// Of a contact with a cohesive zone; units of Maugis. It must end where it can come to rest: U(end) above
/// the potential of static equilibrium. @throws ConvergenceError
[[nodiscard]] CriticalImpacts critical_impacts(const CohesiveMotion& motion);

/// Of an elastic-plastic contact up to the overlap @p farthest (scaled). The rebound depends on the greatest
/// contact reached. So the first step is to find every greatest contact from which unloading arrives at the
/// end of contact at rest; there may be several, since rebound need not be monotone. The second step follows
/// the loading branches backward from there. @throws ConvergenceError
[[nodiscard]] CriticalImpacts critical_impacts(const PlasticMotion<Extended>& motion, Extended farthest);

/// Where a critical orbit is followed backward from: at, or just before, the end of contact.
struct Arrival {
    MotionState<Extended> state;
    Extended dissipated_after = 0;           ///< work of damping from that state to the end
    std::optional<Extended> time_after = 0;  ///< from that state to the end; none if infinite
};

/// The critical impact of an orbit followed backward from @p arrival to the state @p touch at first touch.
[[nodiscard]] CriticalImpact critical_impact(const Arrival& arrival, const MotionState<Extended>& touch,
                                             Extended plastic, Extended break_energy,
                                             Extended maximum_overlap);

/// The orbit that arrives at the end of contact with no velocity left; none if no orbit does. Without
/// adhesion there is one only if the damping does not vanish with the contact radius.
[[nodiscard]] std::optional<Arrival> critical_arrival(const Motion<Extended>& motion);

/// Beyond this coordinate, in units of the equilibrium or of the damping length, a backward orbit has
/// escaped. So it has where the coefficients of its series leave the range of numbers, as those of a damping
/// that grows with a high power of the contact radius do before.
inline constexpr Extended escape = 1e25_ext;

/// Expands for a step backward in time.
template <class Branch>
[[nodiscard]] MotionExpansion<Extended> backward_expansion(const Branch& branch,
                                                           const MotionState<Extended>& state, int& steps) {
    MotionExpansion<Extended> x = counted_expansion(branch, state, steps);
    x.step = -x.step;
    return x;
}

/// Follows the outward leg on a branch backward in time to its turning point; none if the orbit escapes, so
/// that no velocity is high enough to rebound.
/// @param equilibrium coordinate of static equilibrium. @throws ConvergenceError
template <class Branch>
[[nodiscard]] std::optional<MotionState<Extended>> back_to_turn(const Branch& branch,
                                                                MotionState<Extended> state,
                                                                Extended equilibrium) {
    const Extended farthest = escape * std::max({1.0_ext, equilibrium, state.position});
    int steps = 0;
    while (state.position < farthest) {
        const MotionExpansion<Extended> x = backward_expansion(branch, state, steps);
        if (!std::isfinite(x.position.back()) || !std::isfinite(x.velocity.back())) return std::nullopt;
        const auto turn = event_within(x, x.step, [](const MotionState<Extended>& s) { return -s.velocity; });
        state = x.at(turn.value_or(x.step));
        if (!turn) continue;
        state.velocity = 0;
        return state;
    }
    return std::nullopt;
}

/// Follows the inward leg on a branch backward in time to the coordinate @p place; or to rest, where rounding
/// leaves the orbit just short of it. @throws ConvergenceError
template <class Branch>
[[nodiscard]] MotionState<Extended> back_to(const Branch& branch, MotionState<Extended> state,
                                            Extended place) {
    int steps = 0;
    while (true) {
        const MotionExpansion<Extended> x = backward_expansion(branch, state, steps);
        const auto rest = event_within(x, x.step, [](const MotionState<Extended>& s) { return s.velocity; });
        const Extended part = rest.value_or(x.step);
        const auto there = event_within(x, part, way_to(place, -1.0_ext));
        state = x.at(there.value_or(part));
        if (there || rest) return state;
    }
}

}  // namespace ashimpact
