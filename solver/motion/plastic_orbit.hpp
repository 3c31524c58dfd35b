// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/motion/orbit.hpp"
#include "solver/motion/plastic_motion.hpp"

namespace ashimpact {

/// An elastic-plastic impact that touches with scaled velocity @p velocity.
template <class Real>
struct PlasticOrbit {
    Orbit<Real> orbit;
    bool yielded = false;
    Motion<Real> last;    ///< branch of the rebound, or of the equilibrium that a creeping approach tends to
    Motion<Real> path;    ///< branch of orbit.end
    Real plastic_work{};  ///< spent in yielding
};

/// Follows an elastic-plastic impact; see follow().
template <class Real, class Observer>
[[nodiscard]] PlasticOrbit<Real> follow_plastic(const PlasticMotion<Real>& motion, Real velocity,
                                                Observer&& observe) {
    PlasticOrbit<Real> result;
    Orbit<Real>& orbit = result.orbit;
    const Motion<Real>& elastic = motion.elastic();
    const Motion<Real>& loading = motion.loading();
    MotionState<Real> state{.position = elastic.touch, .velocity = velocity};
    bool passes = false;
    if (!motion.yields_at_touch()) {
        result.last = result.path = elastic;
        const std::optional<Real> yield = elastic.coordinate(motion.yield());
        // Only an approach that creeps for ever is cut short; any other is followed through its yield point.
        constexpr int many_steps = 1000;
        const auto creeps_beyond = [&](const MotionState<Real>& s) {
            return orbit.steps > many_steps && motion.creeps_through(s);
        };
        const ApproachEnd end = approach<Real>(elastic, state, yield, orbit, observe, creeps_beyond);
        if (end == ApproachEnd::turned) rebound(elastic, state, orbit, observe);
        if (end == ApproachEnd::turned || end == ApproachEnd::creeping) return result;
        passes = end == ApproachEnd::passing;
    }
    result.yielded = true;
    ApproachEnd end = ApproachEnd::creeping;
    if (passes) {
        const Real spent = elastic.potential(state.position) -
                           motion.loading_potential(loading.root_radius(loading.equilibrium));
        orbit.turn = {.position = loading.equilibrium,
                      .velocity = Real(0),
                      .time = state.time,
                      .dissipation = state.dissipation + state.velocity * state.velocity / Real(2) + spent};
        orbit.end = orbit.turn;
        orbit.maximum_overlap = loading.overlap(loading.equilibrium);
    } else {
        state.position = loading.coordinate(motion.yield());
        end = approach<Real>(loading, state, std::nullopt, orbit, observe);
    }
    const Real greatest = loading.root_radius(orbit.turn.position);
    result.last = motion.unloading(greatest);
    orbit.turn.position = result.last.coordinate(greatest);
    result.plastic_work = motion.loading_potential(greatest) - result.last.potential(orbit.turn.position);
    result.path = end == ApproachEnd::turned ? result.last : loading;
    if (end == ApproachEnd::turned) rebound(result.last, orbit.turn, orbit, observe);
    return result;
}

}  // namespace ashimpact
