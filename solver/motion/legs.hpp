// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "solver/motion/branches/capture.hpp"
#include "solver/motion/orbit.hpp"

namespace ashimpact {

enum class StepEnd { none, place, rest };

enum class ApproachEnd {
    turned,    ///< at greatest overlap
    left,      ///< at the place where the branch ends
    creeping,  ///< never turns
};

/// The legs of one impact, each on one branch of its static law. A branch has expand(), overlap() and
/// potential(). @tparam Observer is called with the branch, each expansion and the part of its step used
template <class Real, class Observer>
class Legs {
  public:
    using State = MotionState<Real>;

    Legs(Orbit<Real>& orbit, Observer& observe) : orbit_(orbit), observe_(observe) {}

    /// One Taylor step with the velocity in @p direction (1 inward, -1 outward). It ends early at rest, or
    /// where @p remaining falls through zero.
    template <class Branch, class Remaining>
    StepEnd step(const Branch& branch, State& state, Real direction, const Remaining& remaining) {
        const MotionExpansion<Real> x = counted_expansion(branch, state, orbit_.steps);
        const auto rest = event_within(x, x.step, [&](const State& s) { return direction * s.velocity; });
        const Real part = rest.value_or(x.step);
        const auto place = event(x, part, remaining);
        use(branch, x, place.value_or(part), state);
        return place ? StepEnd::place : rest ? StepEnd::rest : StepEnd::none;
    }
    /// Steps until rest or @p remaining falls through zero; true in the second case.
    template <class Branch, class Remaining>
    bool reach(const Branch& branch, State& state, Real direction, const Remaining& remaining) {
        StepEnd end = StepEnd::none;
        while (end == StepEnd::none) end = step(branch, state, direction, remaining);
        return end == StepEnd::place;
    }
    /// The inward leg: until the motion turns, leaves the branch, or creeps. @p capture.creeps_to(state)
    /// returns the equilibrium that the motion creeps to, if it is certain that it never turns.
    template <class Branch, class Remaining, class Capture>
    ApproachEnd approach(const Branch& branch, State& state, const Remaining& remaining,
                         const Capture& capture) {
        while (true) {
            const StepEnd end = step(branch, state, Real(1), remaining);
            if (end == StepEnd::place) return ApproachEnd::left;
            if (end == StepEnd::rest) {
                state.velocity = Real(0);
                orbit_.turned = true;
                orbit_.turn = orbit_.end = state;
                orbit_.maximum_overlap = branch.overlap(state.position);
                return ApproachEnd::turned;
            }
            if (const std::optional<RestPlace<Real>> rest = capture.creeps_to(state)) {
                const Real energy = state.velocity * state.velocity / Real(2);
                const Real excess = energy + branch.potential(state.position) - rest->potential;
                orbit_.end = state;
                orbit_.turn = {rest->position, Real(0), state.time, state.dissipation + excess};
                orbit_.maximum_overlap = rest->overlap;
                return ApproachEnd::creeping;
            }
        }
    }
    /// The outward leg: until @p remaining falls through zero, which is a rebound, or capture is certain.
    /// @p capture.captured(state) returns whether it is.
    template <class Branch, class Remaining, class Capture>
    void rebound(const Branch& branch, State state, const Remaining& remaining, const Capture& capture) {
        StepEnd end = StepEnd::none;
        // At rest it is bound, even where rounding leaves it the energy to reach the end.
        while (end == StepEnd::none && !capture.captured(state))
            end = step(branch, state, Real(-1), remaining);
        if (end == StepEnd::place) orbit_.outcome = Outcome::rebound;
        orbit_.end = state;
    }
    /// The outward leg of an impact that ends on this branch.
    void rebound(const Motion<Real>& motion, const State& state, const CaptureTest<Real>& capture) {
        rebound(
            motion, state,
            [&](const State& s) -> Real {
                if (motion.end) return s.position - *motion.end;
                if (s.position <= motion.touch) return Real(-1);  // the total force fell through zero before
                return motion.force(s.position) + motion.damping(s.position) * s.velocity;
            },
            capture);
    }
    /// Sets the potentials of an impact whose last branch is @p motion.
    void close_ledger(const Motion<Real>& motion) {
        orbit_.last_potential = motion.potential(orbit_.last().position);
        orbit_.rest_potential = motion.potential(motion.equilibrium);
    }
    /// One step of a captured particle; true where it leaves the branch.
    template <class Branch, class Remaining>
    bool swing(const Branch& branch, State& state, const Remaining& remaining) {
        const MotionExpansion<Real> x = branch.expand(state);
        const auto left = event(x, x.step, remaining);
        use(branch, x, left.value_or(x.step), state);
        return left.has_value();
    }
    /// Whether a captured particle still rings: the energy left is above that of 1 % of @p velocity.
    [[nodiscard]] bool rings(const State& state, Real potential, Real velocity) const {
        const Real energy = state.velocity * state.velocity / Real(2) + potential - orbit_.rest_potential;
        return energy > Real(0.5e-4_ext) * velocity * velocity;
    }
    /// The ringing of a captured particle on one branch, until it ends or for @p most steps.
    void ring(const Motion<Real>& motion, Real velocity, std::size_t most) {
        if (orbit_.outcome == Outcome::rebound) return;
        State state = orbit_.end;
        for (std::size_t i = 0; i < most && rings(state, motion.potential(state.position), velocity); ++i)
            swing(motion, state, Nowhere());
    }

  private:
    template <class Event>
    [[nodiscard]] static std::optional<Real> event(const MotionExpansion<Real>& x, Real limit,
                                                   const Event& event) {
        if constexpr (std::is_same_v<Event, Nowhere>)
            return std::nullopt;
        else
            return event_within(x, limit, event);
    }
    template <class Branch>
    void use(const Branch& branch, const MotionExpansion<Real>& x, Real used, State& state) {
        observe_(branch, x, used);
        state = x.at(used);
    }

    Orbit<Real>& orbit_;
    Observer& observe_;
};

}  // namespace ashimpact
