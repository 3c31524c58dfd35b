// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "solver/motion/branches/motion.hpp"

namespace ashimpact {

/// Scaled overlap and velocity below which a rebound counts as a capture. No instrument would resolve it, and
/// its powers would underflow.
inline constexpr double vanishing_overlap = 1e-100;

/// Decides capture exactly from the present state, so that the integration need not wait for the motion to
/// die out.
template <class Real>
class CaptureTest {
  public:
    explicit CaptureTest(const Motion<Real>& motion);

    /// Whether the energy no longer suffices to reach the end of contact.
    [[nodiscard]] bool bound(const MotionState<Real>& state) const;
    /// After the turn: whether it is so damped that it creeps back and never reaches the end of contact.
    [[nodiscard]] bool creeping(const MotionState<Real>& state) const;
    /// After the turn: whether capture is certain.
    [[nodiscard]] bool captured(const MotionState<Real>& state) const {
        return too_slow_ || bound(state) || creeping(state);
    }
    /// Before the turn: whether it is so damped that it creeps up to equilibrium and never turns.
    [[nodiscard]] bool creeping_up(const MotionState<Real>& state) const;
    /// The equilibrium that it creeps up to, if it does.
    [[nodiscard]] std::optional<RestPlace<Real>> creeps_to(const MotionState<Real>& state) const {
        if (!creeping_up(state)) return std::nullopt;
        return motion_.rest();
    }

  private:
    const Motion<Real>& motion_;
    bool by_place_;           ///< the contact ends at a place, so capture is possible at all
    bool always_overdamped_;  ///< so damped that no impact rebounds, whatever its velocity
    bool too_slow_;           ///< no return is fast enough at equilibrium to reach the end of contact
    Real end_overlap_{};
    Real end_potential_{};
    Real equilibrium_overlap_{};
    Real least_damping_{};  ///< smallest eta(q) beyond equilibrium
};

template <class Real>
CaptureTest<Real>::CaptureTest(const Motion<Real>& motion)
    : motion_(motion), by_place_(motion.end.has_value()) {
    const Real q = motion.equilibrium;
    always_overdamped_ = motion.touch == Real(0) && motion.overdamped;
    end_overlap_ = by_place_ ? motion.overlap(*motion.end) : Real(0);
    end_potential_ = by_place_ ? motion.potential(*motion.end) : Real(0);
    equilibrium_overlap_ = motion.overlap(q);
    least_damping_ = motion.damping(q);
    const Real fastest = motion.fastest_return;
    too_slow_ = by_place_ && fastest * fastest / Real(2) + motion.potential(q) < end_potential_;
}

template <class Real>
bool CaptureTest<Real>::bound(const MotionState<Real>& state) const {
    const Real energy = state.velocity * state.velocity / Real(2) + motion_.potential(state.position);
    return by_place_ && energy < end_potential_;
}

template <class Real>
bool CaptureTest<Real>::creeping(const MotionState<Real>& state) const {
    if (!by_place_) return false;
    if (always_overdamped_) return true;
    if (state.position < motion_.equilibrium) return false;
    const Real way = motion_.overlap(state.position) - end_overlap_;
    if (way < vanishing_overlap && state.velocity > -vanishing_overlap) return true;
    // Below the line v = -(eta/2)(delta - delta_end) the motion cannot get while F <= (eta^2/4)(delta -
    // delta_end).
    return state.velocity >= -least_damping_ / Real(2) * way &&
           Real(4) * motion_.force(state.position) < least_damping_ * least_damping_ * way;
}

template <class Real>
bool CaptureTest<Real>::creeping_up(const MotionState<Real>& state) const {
    if (state.position >= motion_.equilibrium) return false;
    const Real damping = motion_.damping(state.position);
    const Real way = equilibrium_overlap_ - motion_.overlap(state.position);
    // A spiral so tight that it turns beneath rounding only looks like this one.
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * equilibrium_overlap_;
    if (std::abs(way) <= rounding && state.velocity <= damping * rounding) return true;
    if (state.velocity > damping / Real(2) * way) return false;
    // Below the line v = (eta/2)(delta_eq - delta) it stays where dF/d(delta) <= eta^2/4 all the way.
    return motion_.is_soft(state.position, motion_.equilibrium, damping * damping / Real(4));
}

}  // namespace ashimpact
