// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "solver/motion/branches/motion_state.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// Step of a uniform motion, whose series converge everywhere: the coordinate doubles or becomes 0.
template <class Real>
[[nodiscard]] Real uniform_step(const MotionState<Real>& state) {
    using std::abs;
    const Real distance = state.position != Real(0) ? abs(state.position) : Real(1);
    return state.velocity != Real(0) ? distance / abs(state.velocity) : Real(1);
}

/// Whether a return may be a creep: so stiff that the damping draws all velocities together @c ratio times
/// while the coordinate changes by itself, and near the velocity at which damping and force balance.
/// @param stiffness delta' F @param drag delta' eta
template <class Real>
[[nodiscard]] bool may_creep(const MotionState<Real>& state, const Real& stiffness, const Real& drag) {
    using std::abs;
    constexpr int ratio = 1000;
    if (!(state.velocity < Real(0) && drag * state.position > Real(ratio) * -state.velocity)) return false;
    const Real balance = -stiffness / drag;
    return !(abs(state.velocity - balance) > abs(balance) / Real(10));
}

/// A return that has forgotten how it began: the damping balances the force but for a small acceleration,
///
///     v = -(delta' F + dv/dtheta)/(delta' eta),
///
/// which is iterated from dv/dtheta = 0. Its series hold over steps in which the coordinate changes by a part
/// of itself, those of the equation of motion only over the time in which the damping acts. None if the
/// return is not yet there. The return of a Hertz contact by damping in proportion to its force is the
/// uniform motion in which the two cancel.
/// @param state one that may_creep()
/// @param terms_at gives slope delta', stiffness delta' F and drag delta' eta about the state as series:
/// advance() computes a coefficient from those of the position up to it, follow() takes the velocity's
template <class Real, class TermsAt>
[[nodiscard]] std::optional<MotionExpansion<Real>> expand_creep(const MotionState<Real>& state,
                                                                const TermsAt& terms_at) {
    using std::abs;
    // Relative distance from the velocity of the creep within which a return is taken for one. What is left
    // of it dies out before it has moved the coordinate by a thousandth of that.
    constexpr double creep_distance = 1e-12;
    constexpr int creep_passes = 8;  // each adds a factor of some 50 to the accuracy of that velocity
    MotionExpansion<Real> x{};
    x.position[0] = state.position;
    x.time[0] = state.time;
    x.dissipation[0] = state.dissipation;
    Series<Real> braking;  // delta' eta v
    Series<Real> acceleration{};
    const std::size_t order = x.position.size() - 1;
    for (int pass = 0; pass < creep_passes; ++pass) {
        auto terms = terms_at();
        for (std::size_t n = 0; n <= order; ++n) {
            terms.advance(x.position, n);
            braking[n] = -(terms.stiffness[n] + acceleration[n]);
            x.velocity[n] = quotient_coefficient(braking, terms.drag, x.velocity, n);
            if (n == order) break;
            x.position[n + 1] = x.velocity[n] / static_cast<Real>(n + 1);
            terms.follow(x.position, x.velocity, n);
        }
        for (std::size_t n = 0; n < order; ++n)
            acceleration[n] = static_cast<Real>(n + 1) * x.velocity[n + 1];
        for (std::size_t n = 0; n < order; ++n) {
            const Real factor = Real(1) / static_cast<Real>(n + 1);
            x.time[n + 1] = factor * terms.slope[n];
            x.dissipation[n + 1] = factor * product_coefficient(braking, x.velocity, n);
        }
    }
    if (abs(state.velocity - x.velocity[0]) > Real(creep_distance) * abs(x.velocity[0])) return std::nullopt;
    const Real convergence = std::min(radius(x.position), radius(x.velocity));
    constexpr Real e = std::numbers::e_v<Real>;
    x.step =
        convergence == std::numeric_limits<Real>::infinity() ? uniform_step(state) : convergence / (e * e);
    return x;
}

}  // namespace ashimpact
