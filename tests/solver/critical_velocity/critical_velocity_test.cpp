// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/critical_velocity.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/damping_inversion.hpp"
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

DampingProblem problem_of(const ContactCase& c, double w, double velocity, double restitution) {
    ContactPair contact = ash(w);
    contact.yield_pressure = c.yield_pressure;
    return {.law = c.law,
            .detachment = c.detachment,
            .damping_law = c.damping_law,
            .contact = contact,
            .velocity = velocity,
            .restitution = restitution};
}

Impact impact_with(const DampingProblem& problem, double coefficient) {
    return {.law = problem.law,
            .detachment = problem.detachment,
            .damping = {problem.damping_law, coefficient},
            .contact = problem.contact,
            .velocity = problem.velocity};
}

/// Without adhesion neither an end by force nor damping that vanishes at touch captures, but overdamping.
bool has_capturing_damping(const ContactCase& c) {
    if (c.law != Law::of<Hertz>()) return true;
    return c.detachment != Detachment::zero_force &&
           (!vanishes_at_touch(c.damping_law) || std::isfinite(overdamped_squared(c.damping_law)));
}

}  // namespace

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

TEST_CASE(
    "the critical velocity of a cohesive zone is smooth where its fold passes from the gap into the "
    "contact") {
    const auto critical = [](double lambda) {
        const CohesiveMotion motion(CohesiveZone(lambda),
                                    ScaledDamping<Extended>::of(DampingLaw::constant, {0.1_ext}),
                                    Detachment::pull_off, Precision::extended);
        return critical_impacts(motion).impacts.at(0);
    };
    double gap = 0.9;  // the fold is in the gap
    double contact = 0.95;
    REQUIRE_FALSE(CohesiveZone(gap).pull_off().touching());
    REQUIRE(CohesiveZone(contact).pull_off().touching());
    while (contact - gap > 2e-16) {
        const double middle = gap + (contact - gap) / 2;
        (CohesiveZone(middle).pull_off().touching() ? contact : gap) = middle;
    }
    const CriticalImpact beyond = critical(contact + 1e-9);
    for (double distance = 1e-16; distance < 1e-9; distance *= 1.1) {
        CAPTURE(distance);
        const CriticalImpact nearer = critical(gap - distance);
        CHECK(std::abs(nearer.velocity / beyond.velocity - 1) < 1e-8_ext);
        CHECK(std::abs(nearer.contact_time.value() / beyond.contact_time.value() - 1) < 1e-3_ext);
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

TEST_CASE("double precision gives the verdict, and the critical velocity to 1e-12" *
          doctest::test_suite("long")) {
    Worst worst;
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            for (const double number : {1e-6, 0.01, 0.1, 0.4, 0.7, 5.0}) {
                const Impact impact = impact_of(c, ash(w), number, 2.0);
                const CriticalVelocityProblem problem{impact.law, impact.detachment, impact.damping,
                                                      impact.contact};
                const CriticalVelocity exact = critical_velocity(problem);
                const CriticalVelocity quick = critical_velocity(problem, Precision::standard);
                CAPTURE(describe(impact));
                CHECK(quick.verdict == exact.verdict);
                CHECK(quick.value.has_value() == exact.value.has_value());
                if (exact.value && quick.value)
                    worst.see(relative_difference(*quick.value, *exact.value), describe(impact));
            }
        }
    }
    CHECK(worst.count() > 100);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("restitution to damping and back, for every law, damping law and detachment") {
    Worst there;
    Worst back;
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            const double greatest = solve_impact(impact_with(problem_of(c, w, 2.0, 0.0), 0.0)).restitution;
            for (const double part : {0.01, 0.1, 0.5, 0.9, 0.98}) {
                const double e = part * greatest;
                const DampingProblem problem = problem_of(c, w, 2.0, e);
                const DampingInversion inversion = damping_from_restitution(problem);
                CAPTURE(name_of(c));
                CHECK(inversion.damping.law == c.damping_law);
                CHECK(inversion.damping.coefficient > 0.0);
                CHECK(inversion.impacts > 0);
                // By energies, not by following the undamped impact: another rounding.
                CHECK(std::abs(inversion.greatest_restitution - greatest) <= 3e-16);
                CHECK(inversion.impact.outcome == Outcome::rebound);
                const Impact again = impact_with(problem, inversion.damping.coefficient);
                there.see(std::abs(solve_impact(again).restitution - e), describe(again));
                there.see(std::abs(inversion.impact.restitution - e), describe(again));
                for (const double part_off : {1e-11, 0.3}) {
                    const double near = inversion.damping.coefficient * (1.0 + part_off);
                    const double same = damping_from_restitution(problem, near).damping.coefficient;
                    CHECK(relative_difference(same, inversion.damping.coefficient) < 1e-14);
                }
            }
            for (const double number : {0.01, 0.1, 0.4, 0.7}) {
                const Impact impact = impact_of(c, ash(w), number, 2.0);
                const double e = solve_impact(impact).restitution;
                if (e == 0.0) continue;
                const double found = damping_from_restitution(problem_of(c, w, 2.0, e)).damping.coefficient;
                back.see(relative_difference(found, impact.damping.coefficient), describe(impact));
            }
        }
    }
    CHECK(back.count() > 200);
    CHECK_MESSAGE(there.deviation() < 1e-12, there.where());
    CHECK_MESSAGE(back.deviation() < 1e-12, back.where());
}

TEST_CASE("restitution zero gives the smallest damping that captures") {
    int found = 0;
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            const DampingProblem problem = problem_of(c, w, 2.0, 0.0);
            CAPTURE(name_of(c));
            if (!has_capturing_damping(c)) continue;
            const DampingInversion inversion = damping_from_restitution(problem);
            const double smallest = inversion.damping.coefficient;
            CAPTURE(smallest);
            CHECK(inversion.impact.outcome == Outcome::capture);
            CHECK(solve_impact(impact_with(problem, smallest)).outcome == Outcome::capture);
            // Hertz with Tsuji's damping rebounds up to sqrt5, but with exp(-pi/sqrt(2 (1 - zeta))).
            const bool linear = c.law == Law::of<Hertz>() && c.damping_law == DampingLaw::tsuji;
            if (linear) CHECK(smallest == std::sqrt(5.0));
            const double below = smallest * (1.0 - (linear ? 1e-3 : 1e-9));
            CHECK(solve_impact(impact_with(problem, below)).outcome == Outcome::rebound);
            ++found;
        }
    }
    CHECK(found >= 30);
}

TEST_CASE("the greatest restitution belongs to no damping, and inverts to it") {
    for (const ContactCase& c : contact_cases()) {
        const DampingInversion inversion = damping_from_restitution(problem_of(c, 1.0, 2.0, 0.5));
        const double greatest = inversion.greatest_restitution;
        CAPTURE(name_of(c));
        CHECK(greatest == solve_impact(impact_with(problem_of(c, 1.0, 2.0, 0.5), 0.0)).restitution);
        const DampingInversion limit = damping_from_restitution(problem_of(c, 1.0, 2.0, greatest));
        CHECK(limit.damping.coefficient == 0.0);
    }
}

TEST_CASE("just below the greatest restitution there is just a little damping") {
    for (const ContactCase& c : contact_cases()) {
        const double greatest = damping_from_restitution(problem_of(c, 0.3, 2.0, 0.5)).greatest_restitution;
        CAPTURE(name_of(c));
        const auto damping_at = [&](double loss) {
            return damping_from_restitution(problem_of(c, 0.3, 2.0, greatest - loss)).damping.coefficient;
        };
        const double ulp = greatest - std::nextafter(greatest, 0.0);
        // Restitution falls in proportion to so little damping; the greatest one is itself rounded by half an
        // ulp.
        const double slope = damping_at(std::ldexp(ulp, 26)) / std::ldexp(ulp, 26);
        for (const int bits : {0, 1, 4, 10, 20}) {
            const double loss = std::ldexp(ulp, bits);
            CAPTURE(bits);
            CHECK(std::abs(damping_at(loss) / slope - loss) <= 0.51 * ulp + 1e-6 * loss);
        }
    }
}

TEST_CASE("however small the restitution, no damping is nearer than a few numbers") {
    for (const ContactCase& c : contact_cases()) {
        CAPTURE(name_of(c));
        for (const double e : {1e-3, 1e-6, 1e-9}) {
            // Without end by capture restitution falls for ever; its powers of damping are not the point
            // here.
            if (!has_capturing_damping(c)) continue;
            // Hertz with Tsuji's damping: see above.
            if (c.law == Law::of<Hertz>() && c.damping_law == DampingLaw::tsuji && e < 1e-6) continue;
            CAPTURE(e);
            const DampingProblem problem = problem_of(c, 0.3, 2.0, e);
            const double found = damping_from_restitution(problem).damping.coefficient;
            const double little = 8 * std::numeric_limits<double>::epsilon();
            const auto restitution_at = [&](double damping) {
                return solve_impact(impact_with(problem, damping)).restitution;
            };
            CHECK(restitution_at(found * (1.0 + little)) <= e);
            CHECK(restitution_at(found * (1.0 - little)) >= e);
        }
    }
}

TEST_CASE("an unreachable restitution is refused with the reachable range") {
    const auto message = [](const DampingProblem& problem) {
        return input_error_of([&] { return damping_from_restitution(problem); });
    };
    const ContactCase hertz{Law::of<Hertz>(), DampingLaw::constant, Detachment::zero_overlap};
    CHECK(message(problem_of(hertz, 0.0, 2.0, 1.5)) ==
          "restitution 1.5 cannot be reached by damping law 'constant' with contact law 'hertz' at 2 m/s; "
          "allowed: 0 <= e <= 1");
    CHECK(contains(message(problem_of(hertz, 0.0, 2.0, -0.1)), "allowed: 0 <= e <= 1"));
    CHECK(contains(message(problem_of(hertz, 0.0, 2.0, std::numeric_limits<double>::quiet_NaN())),
                   "restitution nan cannot be reached"));

    // By force there is no capture: zero is not reachable, everything above is.
    const ContactCase by_force{Law::of<Hertz>(), DampingLaw::constant, Detachment::zero_force};
    CHECK(contains(message(problem_of(by_force, 0.0, 2.0, 0.0)), "allowed: 0 < e <= 1"));
    CHECK(contains(message(problem_of(by_force, 0.0, 2.0, 1.5)), "allowed: 0 < e <= 1"));
    const ContactCase by_radius{Law::of<Hertz>(), DampingLaw::contact_radius, Detachment::zero_overlap};
    CHECK(contains(message(problem_of(by_radius, 0.0, 2.0, 0.0)), "allowed: 0 < e <= 1"));

    // JKR spends energy on the break: at 0.1 m/s and 1 J/m2 undamped restitution is clearly below 1.
    const ContactCase jkr{Law::of<Jkr>(), DampingLaw::constant, Detachment::pull_off};
    const double greatest = damping_from_restitution(problem_of(jkr, 1.0, 0.1, 0.1)).greatest_restitution;
    CHECK(greatest < 0.99);
    const std::string refused = message(problem_of(jkr, 1.0, 0.1, 0.5 * (1.0 + greatest)));
    CHECK(contains(refused, "allowed: 0 <= e <= 0."));
    CHECK(relative_difference(std::stod(refused.substr(refused.rfind(' ') + 1)), greatest) < 1e-7);
}

TEST_CASE("an impact that is captured without damping has only restitution zero") {
    const ContactCase jkr{Law::of<Jkr>(), DampingLaw::constant, Detachment::pull_off};
    const double analytic = *critical_velocity({jkr.law, jkr.detachment, {}, ash(1.0)}).value;
    const DampingInversion captured = damping_from_restitution(problem_of(jkr, 1.0, 0.5 * analytic, 0.0));
    CHECK(captured.damping.coefficient == 0.0);
    CHECK(captured.impact.outcome == Outcome::capture);
    CHECK(contains(
        input_error_of([&] { return damping_from_restitution(problem_of(jkr, 1.0, 0.5 * analytic, 0.3)); }),
        "allowed: 0, or a velocity at which the impact rebounds"));
}

TEST_CASE("inadmissible impacts are refused before any is solved") {
    DampingProblem problem =
        problem_of({Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap}, 0.3, 2.0, 0.5);
    problem.contact.mass = -1.0;
    CHECK(contains(input_error_of([&] { return damping_from_restitution(problem); }), "mass is -1 kg"));
    problem.contact = ash(0.3);
    problem.velocity = 0.0;
    CHECK(contains(input_error_of([&] { return damping_from_restitution(problem); }), "velocity is 0 m/s"));
    problem.velocity = 2.0;
    problem.detachment = Detachment::pull_off;
    CHECK(contains(input_error_of([&] { return damping_from_restitution(problem); }),
                   "pull-off does not end a contact of law dmt"));
}
