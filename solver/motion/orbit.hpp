// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/impact.hpp"
#include "solver/motion/motion_stepper.hpp"

namespace ashimpact {

/// What became of one impact, scaled.
template <class Real>
struct Orbit {
    Outcome outcome = Outcome::capture;
    bool turned = false;     ///< false: the motion is so damped that it creeps towards equilibrium
    MotionState<Real> turn;  ///< at greatest overlap; or rest at equilibrium, with the time of `end`, if the
                             ///< motion never turns
    MotionState<Real> end;   ///< at detachment, or at the step from which capture was certain
    Real maximum_overlap{};  ///< greatest overlap, or its supremum if the motion never turns
    int steps = 0;
};

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
    /// Before the turn: whether it is so damped that it creeps up to equilibrium and never turns.
    [[nodiscard]] bool creeping_up(const MotionState<Real>& state) const;

  private:
    const Motion<Real>& motion_;
    bool by_place_;           ///< the contact ends at a place, so capture is possible at all
    bool always_overdamped_;  ///< so damped that no impact rebounds, whatever its velocity
    Real end_overlap_{};
    Real end_potential_{};
    Real equilibrium_overlap_{};
    Polynomial<Real> force_slope_;  ///< dF/dq
    Real least_damping_{};          ///< smallest eta(q) beyond equilibrium
};

enum class ApproachEnd {
    turned,    ///< at greatest overlap
    left,      ///< reached the place where the branch ends
    creeping,  ///< never turns
    passing,   ///< never turns: creeps to where the branch ends and on along the next
};

/// For a branch with nothing beyond its end: no approach creeps on from it.
struct EndsHere {
    template <class State>
    [[nodiscard]] bool operator()(const State& /*state*/) const {
        return false;
    }
};

/// The inward leg on one branch, until the motion turns, creeps, or reaches @p leave_at.
/// @p observe is called with the branch, each expansion and the part of its step that was used; @p
/// creeps_beyond with each state of an approach that leaves its branch before equilibrium.
template <class Real, class Observer, class Beyond = EndsHere>
ApproachEnd approach(const Motion<Real>& motion, MotionState<Real>& state,
                     const std::optional<Real>& leave_at, Orbit<Real>& orbit, Observer& observe,
                     const Beyond& creeps_beyond = {});

/// The outward leg on one branch, until detachment or until capture is certain.
template <class Real, class Observer>
void rebound(const Motion<Real>& motion, MotionState<Real> state, Orbit<Real>& orbit, Observer& observe);

/// Both legs of an impact on one branch that touches with scaled velocity @p velocity.
/// @throws ConvergenceError if the step count runs away
template <class Real, class Observer>
[[nodiscard]] Orbit<Real> follow(const Motion<Real>& motion, Real velocity, Observer&& observe);

/// follow() without an observer.
template <class Real>
[[nodiscard]] Orbit<Real> follow(const Motion<Real>& motion, Real velocity) {
    return follow(motion, velocity, [](const Motion<Real>&, const MotionExpansion<Real>&, Real) {});
}

}  // namespace ashimpact

#include "solver/motion/orbit_impl.hpp"
