// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts by Maugis and Dugdale: energies, limits and the critical velocity; tests/oracles integrates them in
// time.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/motion/trajectory.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Impact of fly ash with that transition parameter; velocity and damping in units of Maugis.
Impact maugis(double lambda, double velocity, double damping, DampingLaw law = DampingLaw::constant,
              Detachment detachment = Detachment::pull_off) {
    ContactPair pair = ash(0.3);
    pair.parameters = {{stated_tabor.name, lambda / transition_per_tabor()},
                       {adhesion_damping_ratio.name, 1.0}};
    const double unit = maugis_velocity(pair);
    const Scale scale = Scale::of(pair, unit);
    return {.law = Law::of<MaugisDugdale>(),
            .detachment = detachment,
            .damping = {law, scale.damping_coefficient(law, damping)},
            .contact = pair,
            .velocity = velocity * unit};
}

Impact with_law(Impact impact, Law law, Detachment detachment) {
    impact.law = law;
    impact.detachment = detachment;
    return impact;
}

}  // namespace

TEST_CASE("undamped: e^2 = 1 - W/(m v^2/2), and both jumps are in the ledger") {
    for (const double lambda : {0.05, 0.2, 0.6, 0.7, 0.93, 0.94, 1.5, 5.0, 20.0, 50.0}) {
        for (const double excess : {1.001, 1.5, 10.0, 1e4}) {
            Impact impact = maugis(lambda, 1.0, 0.0);
            const double work = cohesive_separation_energy(impact.contact, lambda);
            impact.velocity = std::sqrt(2.0 * excess * work / impact.contact.mass);
            CAPTURE(lambda);
            CAPTURE(excess);
            const ImpactResult result = solve_impact(impact);
            CHECK(result.outcome == Outcome::rebound);
            CHECK(std::abs(result.restitution * result.restitution - (1.0 - 1.0 / excess)) < 1e-10);
            CHECK(relative_difference(result.energy.jumps, work) < 1e-12);
            CHECK(std::abs(result.energy.residual) <
                  1e-12 * (result.energy.incident + std::abs(result.energy.minimum)));
        }
    }
}

TEST_CASE("undamped critical velocity is Eq. 30 corrected") {
    for (const double lambda : {0.05, 0.7, 0.94, 3.0, 50.0}) {
        const Impact impact = maugis(lambda, 1.0, 0.0);
        const CriticalVelocity critical =
            critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
        REQUIRE(critical.value);
        CAPTURE(lambda);
        CHECK(relative_difference(*critical.value, cohesive_separation_velocity(impact.contact, lambda)) <
              1e-13);
        CHECK(critical.dissipated == 0.0);
    }
}

TEST_CASE("lambda 1000, damped: JKR to 1e-3 in e, closer as lambda grows") {
    for (const double velocity : {3.0, 10.0, 100.0}) {
        const auto distance = [&](double lambda) {
            const Impact impact = maugis(lambda, velocity, 0.1);
            const Impact jkr = with_law(impact, Law::of<Jkr>(), Detachment::pull_off);
            return std::abs(solve_impact(impact).restitution - solve_impact(jkr).restitution);
        };
        CAPTURE(velocity);
        CHECK(solve_impact(maugis(1000.0, velocity, 0.1)).restitution > 0.1);
        CHECK(distance(1000.0) < 1e-3);
        CHECK(distance(10'000.0) < 0.3 * distance(1000.0));
        CHECK(distance(100'000.0) < 0.3 * distance(10'000.0));
    }
}

TEST_CASE("lambda 0.01, damped: DMT continued across the reach to 1e-3 in e, closer as lambda falls") {
    // F = -2 pi w R (1 + delta/h0) for -h0 < delta < 0 gives and takes pi w R h0, undamped; between lies DMT.
    const auto continued = [](const Impact& impact, double lambda) {
        const MaugisUnits units = maugis_units(impact.contact);
        const double gain = units.energy() * 2.0 / (std::numbers::pi * lambda);
        Impact dmt = with_law(impact, Law::of<Dmt>(), Detachment::zero_overlap);
        const double mass = impact.contact.mass;
        dmt.velocity = std::sqrt(impact.velocity * impact.velocity + 2.0 * gain / mass);
        const double out = solve_impact(dmt).rebound_velocity;
        return std::sqrt(std::max(0.0, out * out - 2.0 * gain / mass)) / impact.velocity;
    };
    for (const double velocity : {20.0, 60.0}) {
        const auto distance = [&](double lambda) {
            const Impact impact = maugis(lambda, velocity, 0.1);
            return std::abs(solve_impact(impact).restitution - continued(impact, lambda));
        };
        CAPTURE(velocity);
        CHECK(solve_impact(maugis(0.01, velocity, 0.1)).restitution > 0.3);
        CHECK(distance(0.01) < 1e-3);
        CHECK(distance(0.001) < distance(0.01));
    }
    // Plain DMT, where the kinetic energy is far above what the cohesion gives before contact.
    const Impact fast = maugis(0.01, 3000.0, 0.1);
    const Impact plain = with_law(fast, Law::of<Dmt>(), Detachment::zero_overlap);
    CHECK(std::abs(solve_impact(fast).restitution - solve_impact(plain).restitution) < 1e-4);
}

TEST_CASE(
    "captured just below the critical velocity, rebounding just above, on every branch and with every "
    "damping") {
    int finite = 0;
    for (const double lambda : {0.05, 0.5, 0.8, 0.9375, 0.94, 2.0, 50.0}) {
        for (const DampingLaw damping : all_values<DampingLaw>) {
            for (const Detachment detachment : {Detachment::pull_off, Detachment::zero_overlap}) {
                Impact impact = maugis(lambda, 1.0, 0.3, damping, detachment);
                CAPTURE(describe(impact));
                const CriticalVelocity critical =
                    critical_velocity({impact.law, detachment, impact.damping, impact.contact});
                if (!critical.value) {  // damping in proportion to the force leaves returns too slow to break
                    CHECK(critical.verdict == CaptureVerdict::always_captured);
                    CHECK(vanishes_at_touch(damping));
                    impact.velocity *= 1e3;
                    CHECK(solve_impact(impact).outcome == Outcome::capture);
                    continue;
                }
                ++finite;
                impact.velocity = *critical.value * (1.0 - 1e-9);
                CHECK(solve_impact(impact).outcome == Outcome::capture);
                impact.velocity = *critical.value * (1.0 + 1e-9);
                const ImpactResult above = solve_impact(impact);
                CHECK(above.outcome == Outcome::rebound);
                CHECK(relative_difference(above.maximum_overlap, *critical.maximum_overlap) < 1e-8);
                const double kinetic = 0.5 * impact.contact.mass * *critical.value * *critical.value;
                CHECK(relative_difference(critical.dissipated + critical.detachment_energy, kinetic) < 1e-12);
            }
        }
    }
    CHECK(finite >= 42);
}

TEST_CASE("zero overlap: begins and ends there, so that nothing is lost without damping") {
    for (const double lambda : {0.1, 0.8, 10.0}) {
        const Impact impact = maugis(lambda, 2.0, 0.0, DampingLaw::constant, Detachment::zero_overlap);
        const ImpactResult result = solve_impact(impact);
        CHECK(std::abs(result.restitution - 1.0) < 1e-14);
        CHECK(result.energy.jumps == 0.0);
        CHECK(relative_difference(*result.contact_time, 2.0 * *result.approach_time) < 1e-13);
        CHECK(critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).verdict ==
              CaptureVerdict::never_captured);
    }
}

TEST_CASE("damping from restitution gives the restitution back, across the gap too") {
    for (const double lambda : {0.1, 0.8, 3.0}) {
        const Impact impact = maugis(lambda, 30.0, 0.0);
        for (const double e : {0.0, 0.2, 0.8}) {
            CAPTURE(lambda);
            CAPTURE(e);
            const DampingInversion found = damping_from_restitution(
                {impact.law, impact.detachment, DampingLaw::constant, impact.contact, impact.velocity, e});
            CHECK(std::abs(found.impact.restitution - e) < 1e-12);
        }
    }
}

TEST_CASE("momenta balance, and the trajectory runs from the reach to the break") {
    for (const double lambda : {0.1, 0.8, 3.0}) {
        const Impact impact = maugis(lambda, 30.0, 0.1);
        const MaugisUnits units = maugis_units(impact.contact);
        const CohesiveZone zone(lambda);
        const MomentumBalance balance = momentum_balance(impact);
        CHECK(std::abs(balance.approach.residual) < 1e-12 * balance.incident_momentum);
        CHECK(std::abs(balance.rebound.residual) < 1e-12 * balance.incident_momentum);
        const ImpactResult result = solve_impact(impact);
        const auto points = trajectory(impact, 101);
        CHECK(relative_difference(points.back().time, *result.contact_time) < 1e-14);
        CHECK(relative_difference(points.front().overlap,
                                  -static_cast<double>(zone.reach()) * units.overlap) < 1e-12);
        CHECK(relative_difference(points.back().overlap,
                                  static_cast<double>(zone.overlap(zone.pull_off())) * units.overlap) < 1e-9);
        CHECK(relative_difference(-points.back().velocity, result.rebound_velocity) < 1e-12);
        bool across_gap = false;
        for (const TrajectoryPoint& p : points) {
            if (p.contact_radius == 0.0) CHECK(p.damping_force == 0.0);
            across_gap = across_gap || p.contact_radius == 0.0;
            CHECK(p.attractive_force <= 0.0);
        }
        CHECK(across_gap == (lambda < 0.9));
    }
    // A captured particle rings, across the gap where it can.
    const auto ringing = trajectory(maugis(0.1, 0.5, 0.01), 400);
    CHECK(ringing.size() == 400);
    CHECK(std::abs(ringing.back().velocity) < std::abs(ringing.front().velocity) * 6.0);
}

TEST_CASE("far above the velocity of adhesion contact times are those of Hertz, the approach takes half") {
    // T v_in / delta_max = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10), Johnson 1985, 11.24.
    const double hertz = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
    for (const double lambda : {0.05, 0.5, 5.0}) {
        for (const double velocity : {1e9, 1e12, 1e16}) {
            CAPTURE(lambda);
            CAPTURE(velocity);
            const Impact impact =
                maugis(lambda, velocity, 0.0, DampingLaw::constant, Detachment::zero_overlap);
            const ImpactResult result = solve_impact(impact);
            const double time = result.contact_time.value();
            CHECK(relative_difference(time * impact.velocity / result.maximum_overlap, hertz) < 1e-9);
            CHECK(relative_difference(result.approach_time.value(), time / 2.0) < 1e-9);
        }
    }
}
