// SPDX-License-Identifier: GPL-3.0-or-later
// Dampings that follow the static force, Hunt & Crossley's F_d = zeta F_r d(delta)/dt and Brach & Dunn's of
// two terms, on each branch. Scaled, as in the solver's own units.
#include <cmath>
#include <string>
#include <utility>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/contact/registry.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/follow.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;

namespace {

/// eta = zeta F_r, where F_r is the Hertzian part of the force.
ScaledDamping<Extended> hunt_crossley(Extended zeta) {
    return ScaledDamping<Extended>::of(DampingLaw::hunt_crossley, {zeta});
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

ScaledDamping<Extended> two_terms(double repulsive, double adhesive) {
    return ScaledDamping<Extended>::of(DampingLaw::brach_dunn, {repulsive, adhesive});
}

/// e of an impact at unit velocity by Runge & Kutta's method in time, with the force as a function of u.
double restitution_in_time(double repulsive, double adhesive, double adhesion) {
    // DMT: F = delta^(3/2) - A on zero overlap and above.
    double overlap = 0;
    double velocity = 1;
    constexpr double step = 2e-5;
    const auto rate = [&](double x, double v) {
        const double hertz = x > 0 ? x * std::sqrt(x) : 0;
        return -(hertz - adhesion) - (repulsive * hertz + adhesive * adhesion) * v;
    };
    while (true) {
        const double k1 = rate(overlap, velocity);
        const double k2 = rate(overlap + step / 2 * velocity, velocity + step / 2 * k1);
        const double k3 = rate(overlap + step / 2 * (velocity + step / 2 * k1), velocity + step / 2 * k2);
        const double k4 = rate(overlap + step * (velocity + step / 2 * k2), velocity + step * k3);
        const double next = overlap + step * (velocity + step / 6 * (k1 + k2 + k3));
        const double faster = velocity + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        if (next <= 0) return -(velocity + (faster - velocity) * overlap / (overlap - next));
        overlap = next;
        velocity = faster;
    }
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

TEST_CASE("a return however stiff ends after some dozen steps, at 1/zeta") {
    // Contact times by quadrature of dt = -dv/[F (1 + zeta v)], U = U_max - v/zeta + ln(1 + zeta v)/zeta^2,
    // with 40 digits.
    const struct {
        Extended zeta;
        double time;
    } exact[]{{1e3L, 91.1369041054798187}, {1e6L, 5743.49863080724263}, {1e8L, 91028.2112378782245}};
    for (const auto& [zeta, time] : exact) {
        CAPTURE(static_cast<double>(zeta));
        CHECK(std::abs(static_cast<double>(follow(hertz(zeta), 1.0_ext).end.time) / time - 1) < 1e-12);
    }
    for (const Extended zeta : {1e3L, 1e5L, 1e8L, 1e15L, 1e30L}) {
        const Orbit<Extended> orbit = follow(hertz(zeta), 1.0_ext);
        CAPTURE(static_cast<double>(zeta));
        CHECK(orbit.outcome == Outcome::rebound);
        CHECK(std::abs(static_cast<double>(zeta * orbit.restitution(1) - 1)) < 1e-14);
        const double closed = HuntCrossleyDamping::hertz_restitution(static_cast<double>(zeta));
        CHECK(std::abs(static_cast<double>(zeta) * closed - 1) < 1e-14);
        CHECK(orbit.steps < 200);
        const MotionState<Extended>& last = orbit.last();
        CHECK(std::abs(0.5L - last.velocity * last.velocity / 2 - last.dissipation) < 1e-14L);
    }
}

TEST_CASE("the creep of a stiff return is the motion that shorter steps follow") {
    for (const Extended adhesion : {1e-7L, 1e-5L}) {
        for (const Extended zeta : {800.0L, 3000.0L}) {
            const Motion<Extended> motion = contact<Dmt>(adhesion, zeta, Detachment::zero_overlap);
            const Orbit<Extended> orbit = follow(motion, 1.0_ext);
            CAPTURE(static_cast<double>(adhesion));
            CAPTURE(static_cast<double>(zeta));
            // From halfway on by Runge & Kutta's method in the coordinate: dv/dq = -delta' (eta + F/v).
            Extended q = orbit.turn.position * 0.5L;
            Extended v = -motion.force(q) / motion.damping(q);
            constexpr int count = 400'000;
            const Extended step = -q / count;
            const auto rate = [&](Extended x, Extended u) {
                return x <= 0 ? 0 : -motion.slope(x) * (motion.damping(x) + motion.force(x) / u);
            };
            for (int i = 0; i < count; ++i, q += step) {
                const Extended k1 = rate(q, v);
                const Extended k2 = rate(q + step / 2, v + step / 2 * k1);
                const Extended k3 = rate(q + step / 2, v + step / 2 * k2);
                const Extended k4 = rate(q + step, v + step * k3);
                v += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            }
            REQUIRE(orbit.outcome == Outcome::rebound);
            CHECK(std::abs(static_cast<double>(v / orbit.end.velocity - 1)) < 1e-9);
        }
    }
}

TEST_CASE("the force on a Hertz contact vanishes at touch and nowhere before") {
    for (const Extended zeta : {0.3L, 2.0L, 100.0L, 1e4L}) {
        const Orbit<Extended> by_force = follow(contact<Hertz>(0, zeta, Detachment::zero_force), 1.0_ext);
        const Orbit<Extended> by_place = follow(hertz(zeta), 1.0_ext);
        CAPTURE(static_cast<double>(zeta));
        CHECK(by_force.outcome == Outcome::rebound);
        CHECK(by_force.end.velocity == by_place.end.velocity);
        CHECK(by_force.end.time == by_place.end.time);
    }
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
        const Extended zeta = detachment == Detachment::pull_off ? 5.0L : 10.0L;
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

TEST_CASE("the least damping that captures is found where adhesion is weak") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<Jkr>(), Law::of<Sjkr>()}) {
        for (const DampingLaw damping : {DampingLaw::hunt_crossley, DampingLaw::brach_dunn}) {
            DampingProblem problem{law, law.default_detachment(), damping, test::ash(1e-7), 10.0, 0.0};
            CAPTURE(law.name());
            CAPTURE(name_of(damping));
            if (!law.is_adhesive()) {
                CHECK_THROWS_AS(static_cast<void>(damping_from_restitution(problem)), InputError);
                continue;
            }
            const DampingInversion found = damping_from_restitution(problem);
            CHECK(found.impact.outcome == Outcome::capture);
            Impact impact{law, problem.detachment, found.damping, problem.contact, problem.velocity};
            impact.damping.coefficient *= 1 - 1e-12;
            CHECK(solve_impact(impact).outcome == Outcome::rebound);
            problem.restitution = 1e-5;
            CHECK(std::abs(damping_from_restitution(problem).impact.restitution / 1e-5 - 1) < 1e-8);
        }
    }
}

TEST_CASE("a restitution that rounding of the damping steps over is refused with what is reached") {
    // The well is some 1e14 times as deep as the impact's energy.
    const DampingProblem problem{
        .law = Law::of<Sjkr>(),
        .detachment = Detachment::zero_overlap,
        .damping_law = DampingLaw::hunt_crossley,
        .contact = {.mass = 2.3441706420197456e-14,
                    .effective_radius = 0.0032196586671426847,
                    .contact_modulus = 1986560004.5554245,
                    .work_of_adhesion = 0.0,
                    .parameters = {{cohesion_energy_density.name, 917887783.2043376}}},
        .velocity = 4.6668918047519723,
        .restitution = 0.0063706177148126963};
    const std::string refused = test::input_error_of([&] { return damping_from_restitution(problem); });
    CHECK(refused.find("restitution 0.00637062 is lost in rounding") != std::string::npos);
}

// Brach & Dunn 1995: F_d = (zeta_H F_r + zeta_A |F_a|) d(delta)/dt.

TEST_CASE("two terms: a coefficient of 0 leaves the other, equal ones damp with the whole of the force") {
    const auto e = [](const ScaledDamping<Extended>& damping) {
        return follow(make_motion<Jkr, Extended>(0.2L, damping, Detachment::pull_off), 1.0_ext)
            .restitution(1);
    };
    CHECK(e(two_terms(0.4, 0)) == e(hunt_crossley(0.4)));
    CHECK(e(two_terms(0.4, 0.4)) < e(two_terms(0.4, 0)));
    CHECK(e(two_terms(0, 0)) == e(ScaledDamping<Extended>::none()));
    CHECK(e(two_terms(0, 0.4)) < e(ScaledDamping<Extended>::none()));
    // With w = 0 nothing is left of the second term.
    CHECK(follow(make_motion<Jkr, Extended>(0, two_terms(0.4, 7), Detachment::pull_off), 1.0_ext)
              .restitution(1) ==
          follow(make_motion<Jkr, Extended>(0, hunt_crossley(0.4), Detachment::pull_off), 1.0_ext)
              .restitution(1));
}

TEST_CASE("the adhesive term on Brach & Dunn's contact is damping in proportion to the contact radius") {
    for (const double adhesion : {0.01, 0.1}) {
        const double adhesive = 0.7;
        const auto motion = [&](const ScaledDamping<Extended>& damping) {
            return make_motion<BrachDunn, Extended>(adhesion, damping, Detachment::zero_overlap);
        };
        const Orbit<Extended> one = follow(motion(two_terms(0, adhesive)), 1.0_ext);
        const auto like = ScaledDamping<Extended>::of(DampingLaw::contact_radius,
                                                      {Extended(adhesive) * Extended(adhesion)});
        const Orbit<Extended> other = follow(motion(like), 1.0_ext);
        REQUIRE(one.outcome == Outcome::rebound);
        CHECK(std::abs(one.restitution(1) - other.restitution(1)) < 1e-18L);
        CHECK(std::abs(one.end.time - other.end.time) < 1e-17L);
    }
}

TEST_CASE("two terms give the restitution of an integration in time") {
    for (const auto& [repulsive, adhesive] : {std::pair{0.3, 0.0}, {0.0, 0.8}, {0.3, 0.8}, {0.2, 2.0}}) {
        CAPTURE(repulsive);
        CAPTURE(adhesive);
        const auto motion =
            make_motion<Dmt, Extended>(0.1L, two_terms(repulsive, adhesive), Detachment::zero_overlap);
        const auto e = static_cast<double>(follow(motion, 1.0_ext).restitution(1));
        CHECK(e > 0.1);
        CHECK(std::abs(e - restitution_in_time(repulsive, adhesive, 0.1)) < 1e-6);
    }
}

TEST_CASE("two terms on a cohesive zone: limits of DMT and JKR, ledger, v_c") {
    const ScaledDamping<Extended> damping = two_terms(0.3, 0.5);
    const auto closes = [](const auto& motion, const Orbit<Extended>& orbit, Extended velocity) {
        const MotionState<Extended>& last = orbit.last();
        const Extended after = last.velocity * last.velocity / 2 + orbit.last_potential + last.dissipation +
                               orbit.plastic_work + orbit.jumps;
        static_cast<void>(motion);
        const Extended before = velocity * velocity / 2 + orbit.touch_potential;
        CHECK(std::abs(before - after) < 1e-15L * std::abs(before));
    };
    // Units of Maugis, in which the adhesion number of DMT is 2 and that of JKR sqrt(8/3), |F_a| = sqrt(6
    // a^3).
    const auto of_zone = [&](Extended lambda, Detachment detachment) {
        return CohesiveMotion(CohesiveZone(lambda), damping, detachment, Precision::extended);
    };
    const CohesiveMotion hard = of_zone(1e-3L, Detachment::zero_overlap);
    const Motion<Extended> dmt = make_motion<Dmt, Extended>(2, damping, Detachment::zero_overlap);
    const CohesiveMotion soft = of_zone(1e3L, Detachment::pull_off);
    const Motion<Extended> jkr =
        make_motion<Jkr, Extended>(std::sqrt(8.0_ext / 3), damping, Detachment::pull_off);
    for (const Extended velocity : {8.0L, 20.0L}) {
        const auto differ = [&](const CohesiveMotion& zone, const Motion<Extended>& limit) {
            const Orbit<Extended> orbit = follow(zone, velocity);
            closes(zone, orbit, velocity);
            return std::abs(orbit.restitution(velocity) - follow(limit, velocity).restitution(velocity));
        };
        CHECK(differ(hard, dmt) < 1e-2L);
        CHECK(differ(soft, jkr) < 1e-2L);
    }
    // The rebound velocity stays below 1/zeta at every velocity: too little here to break the contact.
    const CohesiveMotion strong = of_zone(0.7L, Detachment::pull_off);
    CHECK(critical_impacts(strong).verdict == CaptureVerdict::always_captured);
    CHECK(follow(strong, 1e4_ext).outcome == Outcome::capture);
    const CohesiveMotion weak(CohesiveZone(0.7L), two_terms(0.05, 0.1), Detachment::pull_off,
                              Precision::extended);
    const CriticalImpacts found = critical_impacts(weak);
    REQUIRE(found.impacts.size() == 1);
    CHECK(parts_outcomes(weak, found.impacts.front().velocity, 1e-9L));
}

TEST_CASE("a stiff return on a cohesive zone has forgotten how fast it began") {
    for (const Extended lambda : {0.1L, 0.7L, 3.0L}) {
        for (const double adhesive : {0.0, 0.1}) {
            CAPTURE(static_cast<double>(lambda));
            const CohesiveMotion zone(CohesiveZone(lambda), two_terms(0.02, adhesive), Detachment::pull_off,
                                      Precision::extended);
            const auto rebound = [&](Extended velocity) {
                const Orbit<Extended> orbit = follow(zone, velocity);
                CHECK(orbit.outcome == Outcome::rebound);
                CHECK(orbit.steps < 1000);
                return orbit.end.velocity;
            };
            const Extended slow = rebound(1e5L);
            for (const Extended velocity : {1e7L, 1e9L, 1e13L})
                CHECK(std::abs(static_cast<double>(rebound(velocity) / slow - 1)) < 1e-12);
        }
    }
}

TEST_CASE("two terms: v_c parts capture and rebound, the ledger of a yielded contact closes") {
    for (const double adhesive : {0.1, 3.0}) {
        for (const Motion<Extended>& motion :
             {make_motion<Dmt, Extended>(0.01L, two_terms(0.5, adhesive), Detachment::zero_overlap),
              make_motion<Jkr, Extended>(0.1L, two_terms(0.5, adhesive), Detachment::pull_off)}) {
            const CriticalImpacts found = critical_impacts(motion);
            REQUIRE(found.impacts.size() == 1);
            CHECK(parts_outcomes(motion, found.impacts.front().velocity, 1e-9L));
        }
        const PlasticMotion<Extended> plastic({0.1L, 0.3L}, two_terms(0.2, adhesive), Detachment::pull_off);
        const Orbit<Extended> orbit = follow(plastic, 1.0_ext);
        const MotionState<Extended>& last = orbit.last();
        const Extended after =
            last.velocity * last.velocity / 2 + orbit.last_potential + last.dissipation + orbit.plastic_work;
        CHECK(std::abs(0.5L + orbit.touch_potential - after) < 1e-17L);
    }
}
