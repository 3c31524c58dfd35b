// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "core/text/error.hpp"
#include "solver/motion/branches/motion_state.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// What became of one impact, scaled.
template <class Real>
struct Orbit {
    Outcome outcome = Outcome::capture;
    bool turned = false;     ///< false: the motion is so damped that it creeps towards equilibrium
    bool yielded = false;    ///< the contact went beyond its yield pressure
    MotionState<Real> turn;  ///< at greatest overlap; or rest at equilibrium, with the time of `end`, if the
                             ///< motion never turns
    MotionState<Real> end;   ///< at detachment, or at the step from which capture was certain
    Real maximum_overlap{};  ///< greatest overlap, or its supremum if the motion never turns
    int steps = 0;

    Real touch_potential{};  ///< U at first touch
    Real last_potential{};   ///< U at last()
    Real rest_potential{};   ///< U at static equilibrium, of the last branch
    Real plastic_work{};     ///< spent in yielding
    Real jumps{};            ///< energy lost where the surfaces jump together and apart

    /// Where the ledger ends: detachment, of a capture `turn`.
    [[nodiscard]] const MotionState<Real>& last() const { return outcome == Outcome::rebound ? end : turn; }
    /// e_n of an impact with this scaled velocity [1].
    [[nodiscard]] Real restitution(const Real& velocity) const {
        using std::abs;
        return outcome == Outcome::rebound ? abs(end.velocity) / velocity : Real(0);
    }
};

inline constexpr int most_steps = 20000;

/// Pseudo-time within [0, limit] at which @p event falls through zero, or none; it must be positive at first.
template <class Real, class Event>
[[nodiscard]] std::optional<Real> event_within(const MotionExpansion<Real>& x, Real limit,
                                               const Event& event) {
    const auto along = [&](Real h) { return event(x.at(h)); };
    if (along(limit) > Real(0)) return std::nullopt;
    return sign_change<Real>(along, limit);
}

/// Expands about a state, counting the steps. @param sense as in Motion::expand() @throws ConvergenceError
/// beyond most_steps
template <class Branch, class Real>
[[nodiscard]] MotionExpansion<Real> counted_expansion(const Branch& branch, const MotionState<Real>& state,
                                                      int& steps, int sense = 1) {
    if (++steps > most_steps) throw ConvergenceError("impact did not end within the step limit");
    return branch.expand(state, sense);
}

/// Distance to the coordinate @p place, for a leg on which the coordinate changes with @p direction.
template <class Real>
[[nodiscard]] auto way_to(Real place, Real direction) {
    return [place, direction](const MotionState<Real>& s) { return direction * (place - s.position); };
}

/// Event of a leg that ends at no place.
struct Nowhere {};

/// An observer that ignores what it sees.
struct Unobserved {
    template <class... Step>
    void operator()(const Step&... /*step*/) const {}
};

}  // namespace ashimpact
