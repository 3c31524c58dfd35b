// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/critical_velocity.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// The 88 um particle of Dong et al. 2013 with the constants that reproduce its Table 4.
ContactPair paper_88() {
    const double radius = 44e-6;
    return {.mass = sphere_mass(radius, 2178.0),
            .effective_radius = radius,
            .contact_modulus = contact_modulus({148.126e9, 0.2}, ElasticBody{193e9, 0.29}),
            .work_of_adhesion = 0.296};
}

double critical_at(Law law, double damping) {
    return critical_velocity({law, law.default_detachment(), {DampingLaw::constant, damping}, paper_88()})
        .value.value();
}

/// d ln v_c / d ln eta.
double exponent(Law law, double damping) {
    return std::log(critical_at(law, damping * 1.001) / critical_at(law, damping / 1.001)) /
           (2.0 * std::log(1.001));
}

}  // namespace

TEST_CASE("verdicts have names") {
    CHECK(name_of(CaptureVerdict::finite) == "finite");
    CHECK(name_of(CaptureVerdict::always_captured) == "always-captured");
    CHECK(name_of(CaptureVerdict::never_captured) == "never-captured");
}

TEST_CASE("critical velocity goes with the fifth power of Hertz damping, with a lower one under adhesion") {
    for (const double damping : {0.0141, 0.0153}) {
        CHECK(std::abs(exponent(Law::of<Hertz>(), damping) - 5.0) < 1e-9);
        CHECK(exponent(Law::of<Dmt>(), damping) < 4.2);
        CHECK(exponent(Law::of<Dmt>(), damping) > 3.8);
        CHECK(exponent(Law::of<BrachDunn>(), damping) < 3.7);
        CHECK(exponent(Law::of<BrachDunn>(), damping) > 3.4);
    }
}

TEST_CASE("the paper's 88 um particle: Table 4 from Table 3, within a per cent") {
    CHECK(relative_difference(critical_at(Law::of<Hertz>(), 0.0153), 1.57) < 0.01);
    CHECK(relative_difference(critical_at(Law::of<Dmt>(), 0.0151), 1.85) < 0.01);
    CHECK(relative_difference(critical_at(Law::of<BrachDunn>(), 0.0141), 1.93) < 0.01);
}

TEST_CASE("a critical velocity says what the impact spent: damping, break, overlap, time") {
    const CriticalVelocityProblem problem{
        Law::of<Jkr>(), Detachment::load_controlled, {DampingLaw::constant, 0.0153}, paper_88()};
    const CriticalVelocity critical = critical_velocity(problem);
    REQUIRE(critical.verdict == CaptureVerdict::finite);
    const double kinetic = 0.5 * problem.contact.mass * *critical.value * *critical.value;
    CHECK(relative_difference(critical.dissipated + critical.detachment_energy, kinetic) < 1e-14);
    CHECK(critical.dissipated > 0.0);
    CHECK(critical.detachment_energy > 0.0);
    REQUIRE(critical.contact_time);
    const ImpactResult just_below = solve_impact(
        {problem.law, problem.detachment, problem.damping, problem.contact, *critical.value * (1.0 - 1e-12)});
    CHECK(just_below.outcome == Outcome::capture);
    CHECK(relative_difference(just_below.maximum_overlap, *critical.maximum_overlap) < 1e-11);
    CHECK(*critical.contact_time > *just_below.approach_time);
}

TEST_CASE("arrival at the end takes a finite time, but for Hertz and sjkr, which creep up to it") {
    for (const ContactCase& c : elastic_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const CriticalVelocity critical =
            critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
        if (critical.verdict != CaptureVerdict::finite) continue;
        CAPTURE(name_of(c));
        const bool creeps = c.law == Law::of<Hertz>() || c.law == Law::of<Sjkr>();  // along v = -const delta
        CHECK(critical.contact_time.has_value() == !creeps);
    }
}

TEST_CASE("the contact time at v_c is the limit of those just above it") {
    // What is missing at v_c (1 + epsilon) falls with epsilon^(1/2) for all but Brach-Dunn (epsilon^(1/6)).
    for (const ContactCase& c : elastic_cases()) {
        if (c.law == Law::of<BrachDunn>()) continue;
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const CriticalVelocity critical =
            critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
        if (!critical.contact_time) continue;
        CAPTURE(name_of(c));
        const auto time_above = [&](double excess) {
            Impact above = impact;
            above.velocity = *critical.value * (1.0 + excess);
            return *solve_impact(above).contact_time;
        };
        const double coarse = 2.0 * time_above(1e-8) - time_above(4e-8);
        const double fine = 2.0 * time_above(2.5e-9) - time_above(1e-8);
        CHECK(relative_difference((4.0 * fine - coarse) / 3.0, *critical.contact_time) < 1e-7);
    }
}

TEST_CASE("the contact time at v_c tends to the undamped one as the damping falls") {
    const CriticalVelocityProblem problem{
        Law::of<Jkr>(), Detachment::pull_off, {DampingLaw::constant, 0.0}, ash(0.3)};
    const CriticalVelocity undamped = critical_velocity(problem);
    REQUIRE(undamped.contact_time);
    double before = 1.0;
    for (const double damping : {1e-4, 1e-6, 1e-8}) {
        CriticalVelocityProblem damped = problem;
        damped.damping.coefficient = damping;
        const double off =
            relative_difference(*critical_velocity(damped).contact_time, *undamped.contact_time);
        CHECK(off < 0.02 * before);  // the deviation is proportional to the damping
        CHECK(off > 0.0);
        before = off;
    }
}

TEST_CASE("ever weaker damping: the critical velocity falls without losing digits") {
    // At w = 0.3 the well is far deeper than the kinetic energy; v_c goes with the root of the damping there.
    for (const Law law : {Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        CAPTURE(law.name());
        for (const double damping : {1e-6, 1e-8, 1e-10, 1e-12}) {
            CAPTURE(damping);
            CHECK(std::abs(critical_at(law, damping) / critical_at(law, damping / 100) - 10.0) < 0.01);
        }
    }
}

TEST_CASE("inadmissible problems are refused") {
    CriticalVelocityProblem problem{
        Law::of<Dmt>(), Detachment::zero_overlap, {DampingLaw::constant, 0.0153}, paper_88()};
    problem.damping.coefficient = -1.0;
    CHECK(contains(input_error_of([&] { return critical_velocity(problem); }), "damping is -1 kg/s"));
    problem.damping.coefficient = 0.0153;
    problem.contact.mass = 0.0;
    CHECK(contains(input_error_of([&] { return critical_velocity(problem); }), "mass is 0 kg"));
    problem.contact = paper_88();
    problem.detachment = Detachment::zero_force;
    CHECK(contains(input_error_of([&] { return critical_velocity(problem); }),
                   "zero-force does not end a contact of law dmt"));
}

TEST_CASE(
    "sjkr: attraction and overlap vanish together, so v_c is reached in infinite time, and to all digits") {
    // Bisected between capture and rebound of an independent time-domain integration (DOP853, rtol 1e-13,
    // tests/data/reference/impacts.py), to 7e-12 and 2e-9.
    const struct {
        double damping;
        double value;
        double accuracy;
    } references[]{{0.0141, 0.86073302185687, 1e-11}, {0.002, 0.00340318197946675, 2e-9}};
    const Law law = Law::of<Sjkr>();
    for (const auto& reference : references) {
        const CriticalVelocity critical = critical_velocity(
            {law, law.default_detachment(), {DampingLaw::constant, reference.damping}, ash(0.3)});
        REQUIRE(critical.value);
        CHECK(relative_difference(*critical.value, reference.value) < reference.accuracy);
        CHECK_FALSE(critical.contact_time);
    }
    for (const DampingLaw damping : all_values<DampingLaw>) {
        const ContactCase c{law, damping, Detachment::zero_overlap};
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const CriticalVelocity critical =
            critical_velocity({law, impact.detachment, impact.damping, impact.contact});
        CAPTURE(name_of(damping));
        CHECK(critical.value);
        CHECK_FALSE(critical.contact_time);
    }
}
