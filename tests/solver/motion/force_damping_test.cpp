// SPDX-License-Identifier: GPL-3.0-or-later
// A damping that follows the static force (Hunt & Crossley 1975), F_d = zeta F_r d(delta)/dt: the equation of
// motion takes eta as the damping law gives it on each branch. Scaled, as in the solver's own units.
#include <cmath>

#include <doctest/doctest.h>

#include "solver/contact/registry.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/follow.hpp"

using namespace ashimpact;

namespace {

/// eta = zeta F_r, where F_r is the Hertzian part of the force.
ScaledDamping<Extended> hunt_crossley(Extended zeta) {
    return {[zeta](const StaticBranch<Extended>& branch) { return zeta * branch.repulsion; }, false};
}

/// A contact of law L at adhesion number @p adhesion.
template <template <class> class L>
Motion<Extended> contact(Extended adhesion, Extended zeta, Detachment detachment) {
    return make_motion<L, Extended>(adhesion, hunt_crossley(zeta), detachment);
}

Motion<Extended> hertz(Extended zeta) {
    return contact<Hertz>(0, zeta, Detachment::zero_overlap);
}

/// Whether impacts change at this velocity from capture to rebound, or back.
template <class Branches>
bool parts_outcomes(const Branches& branches, Extended velocity, Extended margin) {
    return follow(branches, velocity * (1 - margin)).outcome !=
           follow(branches, velocity * (1 + margin)).outcome;
}

/// The impact on the side of a critical velocity on which it rebounds.
Orbit<Extended> rebound_near(const PlasticMotion<Extended>& motion, Extended critical) {
    const Orbit<Extended> above = follow(motion, critical * (1 + 1e-9L));
    return above.outcome == Outcome::rebound ? above : follow(motion, critical * (1 - 1e-9L));
}

}  // namespace

TEST_CASE("Hertz: zeta v (1 + e) = ln[(1 + zeta v)/(1 - zeta v e)]") {
    // Roots of that equation, by a solver of their own.
    const struct {
        Extended zeta;
        double restitution;
    } exact[]{
        {0.1L, 0.937475579950}, {0.4L, 0.788539125907}, {2.0L, 0.410719686061}, {10.0L, 0.099981624753}};
    for (const auto& [zeta, restitution] : exact) {
        const auto e = follow(hertz(zeta), 1.0_ext).restitution(1);
        CAPTURE(static_cast<double>(zeta));
        CHECK(std::abs(static_cast<double>(e) - restitution) < 1e-12);
        CHECK(std::abs(static_cast<double>(zeta * (1 + e) - std::log((1 + zeta) / (1 - zeta * e)))) < 1e-14);
    }
    // Beyond zeta v = 50 the return has reached -1/zeta to rounding long before the contact ends.
    for (const Extended zeta : {50.0L, 1e3L, 1e4L})
        CHECK(std::abs(static_cast<double>(zeta * follow(hertz(zeta), 1.0_ext).restitution(1) - 1)) < 1e-14);
}

TEST_CASE("a return at exactly -1/zeta is uniform, and ends where the contact ends") {
    const Motion<Extended> motion = hertz(2);
    Orbit<Extended> orbit;
    Extended covered = 0;
    const auto add = [&](const auto& branch, const MotionExpansion<Extended>& x, Extended used) {
        covered += branch.overlap(x.position[0]) - branch.overlap(value(x.position, used));
    };
    Legs legs(orbit, add);
    legs.rebound(motion, {.position = 1, .velocity = -0.5L}, CaptureTest<Extended>(motion));
    CHECK(orbit.outcome == Outcome::rebound);
    CHECK(orbit.end.velocity == -0.5L);
    CHECK(orbit.end.position == 0);
    CHECK(std::abs(orbit.end.time - 2 * motion.overlap(1)) < 1e-18L);
    CHECK(std::abs(covered - motion.overlap(1)) < 1e-18L);
}

TEST_CASE("without adhesion every impact rebounds; with it v_c parts capture and rebound") {
    CHECK(critical_impacts(hertz(3)).verdict == CaptureVerdict::never_captured);
    for (const Extended zeta : {0.1L, 1.0L, 5.0L}) {
        const auto parts = [&](const Motion<Extended>& motion) {
            const CriticalImpacts found = critical_impacts(motion);
            CAPTURE(static_cast<double>(zeta));
            REQUIRE(found.impacts.size() == 1);
            CHECK(parts_outcomes(motion, found.impacts.front().velocity, 1e-9L));
        };
        parts(contact<Dmt>(0.01L, zeta, Detachment::zero_overlap));
        parts(contact<BrachDunn>(0.01L, zeta, Detachment::zero_overlap));
        parts(contact<Jkr>(0.1L, zeta, Detachment::pull_off));
        parts(contact<Jkr>(0.1L, zeta, Detachment::load_controlled));
    }
}

TEST_CASE(
    "where 1/zeta is too slow to break the contact, the backward orbit escapes: every impact is captured") {
    for (const Extended zeta : {100.0L, 1e4L, 1e8L}) {
        CAPTURE(static_cast<double>(zeta));
        for (const Motion<Extended>& motion : {contact<Dmt>(0.1L, zeta, Detachment::zero_overlap),
                                               contact<Jkr>(0.1L, zeta, Detachment::pull_off),
                                               contact<Jkr>(1, zeta, Detachment::load_controlled)}) {
            const CriticalImpacts found = critical_impacts(motion);
            CHECK(found.verdict == CaptureVerdict::always_captured);
            CHECK(found.impacts.empty());
            CHECK(follow(motion, 1.0_ext).outcome == Outcome::capture);
        }
    }
}

TEST_CASE(
    "elastic-plastic: the work of adhesion grows with the flattening, which captures fast impacts again") {
    for (const Detachment detachment : {Detachment::pull_off, Detachment::load_controlled}) {
        for (const Extended zeta : {5.0L, 10.0L}) {
            const PlasticMotion<Extended> motion({0.1L, 0.3L}, hunt_crossley(zeta), detachment);
            const CriticalImpacts found = critical_impacts(motion, 1000);
            CAPTURE(static_cast<double>(zeta));
            REQUIRE(found.impacts.size() == 2);
            // Backward the orbits of the upper one turn at a quarter of its contact or escape.
            for (const CriticalImpact& impact : found.impacts) {
                CHECK(parts_outcomes(motion, impact.velocity, 1e-9L));
                const Orbit<Extended> rebound = rebound_near(motion, impact.velocity);
                CHECK(std::abs(rebound.plastic_work - impact.plastic) < 1e-7L * (1 + impact.plastic));
                CHECK(std::abs(rebound.end.dissipation - impact.dissipated) < 1e-7L * impact.dissipated);
                CHECK(std::abs(rebound.end.time - *impact.contact_time) < 1e-2L * *impact.contact_time);
            }
            CHECK(follow(motion, found.impacts[0].velocity / 2).outcome == Outcome::capture);
            CHECK(follow(motion, found.impacts[0].velocity * 2).outcome == Outcome::rebound);
            CHECK(follow(motion, found.impacts[1].velocity * 2).outcome == Outcome::capture);
        }
    }
    CHECK(critical_impacts(
              PlasticMotion<Extended>({0.3L, 0.3L}, hunt_crossley(5), Detachment::load_controlled), 1000)
              .verdict == CaptureVerdict::always_captured);
}

TEST_CASE("the ledger of an impact closes") {
    for (const Extended zeta : {0.1L, 1.0L, 10.0L}) {
        const auto closes = [&](const auto& branches) {
            const Orbit<Extended> orbit = follow(branches, 1.0_ext);
            const MotionState<Extended>& last = orbit.last();
            const Extended after = last.velocity * last.velocity / 2 + orbit.last_potential +
                                   last.dissipation + orbit.plastic_work + orbit.jumps;
            CHECK(std::abs(0.5L + orbit.touch_potential - after) < 1e-17L);
        };
        closes(hertz(zeta));
        closes(contact<Sjkr>(0.1L, zeta, Detachment::zero_overlap));
        closes(contact<Jkr>(0.1L, zeta, Detachment::pull_off));
        closes(PlasticMotion<Extended>({0.1L, 0.3L}, hunt_crossley(zeta), Detachment::pull_off));
    }
}
