// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/branches/plastic_motion.hpp"
#include "solver/motion/legs.hpp"

namespace ashimpact {

/// Follows an impact that touches with scaled velocity @p velocity, on one branch. @p observe is called with
/// the branch, each expansion and the part of its step that was used; of a capture also for up to @p ringing
/// steps of what follows it.
/// @throws ConvergenceError if the step count runs away
template <class Real, class Observer = Unobserved>
Orbit<Real> follow(const Motion<Real>& motion, Real velocity, Observer&& observe = {},
                   std::size_t ringing = 0) {
    Orbit<Real> orbit;
    Legs legs(orbit, observe);
    MotionState<Real> state{.position = motion.touch, .velocity = velocity};
    const CaptureTest<Real> capture(motion);
    if (legs.approach(motion, state, Nowhere(), capture) == ApproachEnd::turned)
        legs.rebound(motion, state, capture);
    orbit.touch_potential = motion.potential(motion.touch);
    legs.close_ledger(motion);
    legs.ring(motion, velocity, ringing);
    return orbit;
}

/// Follows an elastic-plastic impact: elastic loading, plastic loading, unloading.
template <class Real, class Observer = Unobserved>
Orbit<Real> follow(const PlasticMotion<Real>& motion, Real velocity, Observer&& observe = {},
                   std::size_t ringing = 0) {
    Orbit<Real> orbit;
    Legs legs(orbit, observe);
    orbit.touch_potential = motion.touch_potential();
    const Motion<Real>& elastic = motion.elastic();
    const Motion<Real>& loading = motion.loading();
    MotionState<Real> state{.position = elastic.touch, .velocity = velocity};
    ApproachEnd end = ApproachEnd::left;
    if (!motion.yields_at_touch()) {
        const Real yield = elastic.coordinate(motion.yield());
        const CaptureTest<Real> capture(elastic);
        const bool leaves_first = yield < elastic.equilibrium;
        const auto way = way_to(yield, Real(1));
        end = leaves_first ? legs.approach(elastic, state, way, YieldingCreep<Real>{motion, orbit.steps})
                           : legs.approach(elastic, state, way, capture);
        if (end == ApproachEnd::turned) legs.rebound(elastic, state, capture);
        if (end == ApproachEnd::turned || (end == ApproachEnd::creeping && !leaves_first)) {
            legs.close_ledger(elastic);
            legs.ring(elastic, velocity, ringing);
            return orbit;
        }
    }
    orbit.yielded = true;
    if (end == ApproachEnd::creeping) {  // through yield
        orbit.end = orbit.turn;
    } else {
        state.position = loading.coordinate(motion.yield());
        end = legs.approach(loading, state, Nowhere(), CaptureTest<Real>(loading));
    }
    const Real greatest = loading.root_radius(orbit.turn.position);
    const Motion<Real> unloading = motion.unloading(greatest);
    orbit.turn.position = unloading.coordinate(greatest);
    orbit.plastic_work = motion.loading_potential(greatest) - unloading.potential(orbit.turn.position);
    const bool turned = end == ApproachEnd::turned;
    if (turned) legs.rebound(unloading, orbit.turn, CaptureTest<Real>(unloading));
    legs.close_ledger(unloading);
    legs.ring(turned ? unloading : loading, velocity, ringing);
    return orbit;
}

/// The ringing of a captured particle from @p state on, in contact and across the gap.
template <class Observer>
void ring(const CohesiveMotion& motion, Legs<Extended, Observer>& legs, MotionState<Extended> state,
          bool in_gap, Extended velocity, std::size_t most) {
    const TouchingBranch& touching = motion.touching();
    const GapBranch& gap = motion.gap();
    const CohesiveState join = motion.zone().join();
    const Extended edge = touching.coordinate(join);
    const Extended gap_edge = join.cohesive_radius;
    for (std::size_t i = 0; i < most; ++i) {
        const Extended potential =
            in_gap ? gap.potential(state.position) : touching.potential(state.position);
        if (!legs.rings(state, potential, velocity)) return;
        const bool crosses = in_gap ? legs.swing(gap, state, way_to(gap_edge, 1.0_ext))
                                    : legs.swing(touching, state, way_to(edge, -1.0_ext));
        if (!crosses) continue;
        in_gap = !in_gap;
        state.position = in_gap ? gap_edge : edge;
    }
}

/// Follows an impact with a cohesive zone: into reach, across the gap, on to greatest overlap and back out.
template <class Observer = Unobserved>
Orbit<Extended> follow(const CohesiveMotion& motion, Extended velocity, Observer&& observe = {},
                       std::size_t ringing = 0) {
    Orbit<Extended> orbit;
    Legs legs(orbit, observe);
    const TouchingBranch& touching = motion.touching();
    const GapBranch& gap = motion.gap();
    const CohesiveState join = motion.zone().join();
    const Extended edge = touching.coordinate(join);
    const Extended gap_edge = join.cohesive_radius;
    orbit.touch_potential = motion.potential_outside();
    orbit.rest_potential = motion.rest().potential;
    orbit.jumps = motion.potential_outside() - motion.potential_at_begin();
    MotionState<Extended> state{.velocity = velocity};
    if (motion.begin().touching()) {
        state.position = touching.coordinate(motion.begin());
    } else {
        state.position = motion.begin().cohesive_radius;
        legs.reach(gap, state, 1, way_to(gap_edge, 1.0_ext));
        state.position = edge;
    }
    bool in_gap = false;
    if (legs.approach(touching, state, Nowhere(), motion) == ApproachEnd::turned) {
        const bool ends_in_gap = !motion.end().touching();
        const Extended last = ends_in_gap ? edge : touching.coordinate(motion.end());
        legs.rebound(touching, state, way_to(last, -1.0_ext), motion);
        if (orbit.outcome == Outcome::rebound && ends_in_gap) {
            orbit.end.position = gap_edge;
            const auto way = way_to(motion.end().cohesive_radius, -1.0_ext);
            in_gap = true;
            if (!legs.reach(gap, orbit.end, -1, way)) orbit.outcome = Outcome::capture;
        }
    }
    if (orbit.outcome == Outcome::rebound) {
        orbit.jumps += motion.potential_at_end() - motion.potential_outside();
        orbit.last_potential = motion.potential_outside();
        return orbit;
    }
    orbit.last_potential = orbit.turned ? touching.potential(orbit.turn.position) : motion.rest().potential;
    ring(motion, legs, orbit.end, in_gap, velocity, ringing);
    return orbit;
}

}  // namespace ashimpact
