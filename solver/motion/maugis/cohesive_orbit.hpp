// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.hpp"
#include "solver/motion/maugis/cohesive_motion.hpp"
#include "solver/motion/orbit.hpp"

namespace ashimpact {

/// What became of one Maugis-Dugdale impact, scaled. The positions of orbit.turn and orbit.end are
/// coordinates of the branches that turned() and ended() name.
struct CohesiveOrbit {
    Orbit<Extended> orbit;
    CohesiveState turn;          ///< state of greatest overlap, or the equilibrium it tends to
    CohesiveState end;           ///< state of orbit.end
    Extended lost_at_touch = 0;  ///< energy lost in the jump together
    Extended lost_at_break = 0;  ///< energy lost in the jump apart
};

/// Follows one impact leg by leg: into reach, across the gap, on to greatest overlap and back out.
/// @p observe is called with the branch, each expansion and the part of its step that was used.
template <class Observer>
class CohesiveFollower {
  public:
    CohesiveFollower(const CohesiveMotion& motion, Observer& observe) : motion_(motion), observe_(observe) {}

    [[nodiscard]] CohesiveOrbit follow(Extended velocity) {
        MotionState<Extended> state{.velocity = velocity};
        const CohesiveZone& zone = motion_.zone();
        result_.lost_at_touch = motion_.potential_outside() - motion_.potential_at_begin();
        if (motion_.begin().touching()) {
            state.position = motion_.touching().coordinate(motion_.begin());
        } else {
            state.position = GapBranch::coordinate(motion_.begin());
            reach(motion_.gap(), state, GapBranch::coordinate(zone.join()), 1);
            state.position = motion_.touching().coordinate(zone.join());
        }
        if (approach(state)) recede(state);
        return result_;
    }

  private:
    enum class Event { place, turn, step };

    /// One step towards @p place; @p direction +1 where the coordinate rises on the way. Ends at the place or
    /// at rest where one of them lies within the step.
    template <class Branch>
    Event advance(const Branch& branch, MotionState<Extended>& state, std::optional<Extended> place,
                  Extended direction) {
        if (++result_.orbit.steps > most_steps)
            throw ConvergenceError("impact did not end within the step limit");
        const MotionExpansion<Extended> x = branch.expand(state);
        const auto rest =
            event_within(x, x.step, [&](const MotionState<Extended>& s) { return direction * s.velocity; });
        Extended used = rest.value_or(x.step);
        std::optional<Extended> there;
        if (place)
            there = event_within(
                x, used, [&](const MotionState<Extended>& s) { return direction * (*place - s.position); });
        used = there.value_or(used);
        observe_(branch, x, used);
        state = x.at(used);
        return there ? Event::place : rest ? Event::turn : Event::step;
    }

    /// Steps until the place or rest; true at the place.
    template <class Branch>
    bool reach(const Branch& branch, MotionState<Extended>& state, Extended place, Extended direction) {
        Event event = Event::step;
        while (event == Event::step) event = advance(branch, state, place, direction);
        return event == Event::place;
    }

    /// The inward leg in contact; false where it creeps and never turns.
    bool approach(MotionState<Extended>& state) {
        const TouchingBranch& branch = motion_.touching();
        Orbit<Extended>& orbit = result_.orbit;
        while (advance(branch, state, std::nullopt, 1) == Event::step) {
            if (!motion_.creeps_up(state)) continue;
            result_.end = branch.state(state.position);
            result_.turn = motion_.zone().equilibrium();
            orbit.end = orbit.turn = state;
            const Extended rest = motion_.zone().potential(result_.turn);
            orbit.turn.dissipation +=
                state.velocity * state.velocity / 2 + branch.potential(state.position) - rest;
            orbit.turn.position = branch.coordinate(result_.turn);
            orbit.turn.velocity = 0;
            orbit.maximum_overlap = motion_.zone().overlap(result_.turn);
            return false;
        }
        state.velocity = 0;
        orbit.turned = true;
        orbit.turn = orbit.end = state;
        result_.turn = result_.end = branch.state(state.position);
        orbit.maximum_overlap = motion_.zone().overlap(result_.turn);
        return true;
    }

    /// The outward leg, until the contact ends or capture is certain.
    void recede(MotionState<Extended> state) {
        const TouchingBranch& branch = motion_.touching();
        const CohesiveState& last = motion_.end().touching() ? motion_.end() : motion_.zone().join();
        const Extended place = branch.coordinate(last);
        Event event = Event::step;
        while (event == Event::step && !bound(state)) event = advance(branch, state, place, -1);
        result_.orbit.end = state;
        result_.end = event == Event::place ? last : branch.state(state.position);
        if (event != Event::place) return;
        if (!motion_.end().touching()) {
            state.position = GapBranch::coordinate(last);
            const bool broken = reach(motion_.gap(), state, GapBranch::coordinate(motion_.end()), -1);
            result_.orbit.end = state;
            result_.end = broken ? motion_.end() : GapBranch::state(state.position);
            if (!broken) return;
        }
        result_.orbit.outcome = Outcome::rebound;
        result_.lost_at_break = motion_.potential_at_end() - motion_.potential_outside();
    }

    /// The energy no longer suffices to reach the end.
    [[nodiscard]] bool bound(const MotionState<Extended>& state) const {
        const Extended energy =
            state.velocity * state.velocity / 2 + motion_.touching().potential(state.position);
        return energy < motion_.potential_at_end();
    }

    const CohesiveMotion& motion_;
    Observer& observe_;
    CohesiveOrbit result_;
};

/// Follows an impact that comes into reach with scaled velocity @p velocity.
template <class Observer>
[[nodiscard]] CohesiveOrbit follow_cohesive(const CohesiveMotion& motion, Extended velocity,
                                            Observer&& observe) {
    return CohesiveFollower<std::remove_reference_t<Observer>>(motion, observe).follow(velocity);
}

/// follow_cohesive() without an observer.
[[nodiscard]] inline CohesiveOrbit follow_cohesive(const CohesiveMotion& motion, Extended velocity) {
    return follow_cohesive(motion, velocity, [](const auto&, const MotionExpansion<Extended>&, Extended) {});
}

}  // namespace ashimpact
