// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/static_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/errors.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

TEST_CASE("overlap and contact radius name the same point, for every law") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        for (const double w : ash_adhesions) {
            const StaticCurve curve(Law::at(i), ash(w));
            CAPTURE(Law::at(i).name());
            for (const double ratio : {1.0001, 1.1, 2.0, 10.0}) {
                const double a = ratio * std::max(curve.first().contact_radius, 2e-7);
                const StaticPoint point = curve.at_contact_radius(a);
                const StaticPoint same = curve.at_overlap(point.overlap);
                CAPTURE(a);
                CHECK(relative_difference(point.contact_radius, a) < 1e-15);
                // Near the fold of JKR overlap hardly changes with contact radius.
                CHECK(relative_difference(same.contact_radius, a) < 1e-10);
                CHECK(std::abs(same.force() - point.force()) <
                      1e-10 * (point.repulsive_force - point.attractive_force));
            }
        }
    }
}

TEST_CASE(
    "the static force is that of the motion: it vanishes at the equilibrium overlap of a captured particle") {
    // So damped that it creeps up to equilibrium: its greatest overlap is the static one.
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        const StaticCurve curve(law, ash(0.3));
        if (curve.at_overlap(2e-9).attractive_force == 0.0) continue;  // no equilibrium without attraction
        const ImpactResult result =
            solve_impact({law, law.default_detachment(), {DampingLaw::constant, 0.5}, ash(0.3), 1e-3});
        REQUIRE(!result.approach_time);
        const StaticPoint point = curve.at_overlap(result.maximum_overlap);
        CAPTURE(law.name());
        CHECK(std::abs(point.force()) < 1e-13 * point.repulsive_force);
    }
}

TEST_CASE("the curve begins where the law detaches by default") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const StaticCurve curve(Law::at(i), ash(0.3));
        CAPTURE(Law::at(i).name());
        if (Law::at(i).default_detachment() == Detachment::zero_overlap) {
            CHECK(curve.first().overlap == 0.0);
        } else {
            CHECK(curve.first().overlap < 0.0);
        }
        CHECK(curve.at_overlap(curve.first().overlap).contact_radius == curve.first().contact_radius);
    }
}

TEST_CASE("points outside the curve and impossible contacts are refused") {
    const StaticCurve curve(Law::of<Jkr>(), ash(0.3));
    CHECK(contains(input_error_of([&] { static_cast<void>(curve.at_contact_radius(1e-8)); }),
                   "contact_radius is 1e-08 m; allowed: "));
    CHECK(contains(input_error_of([&] { static_cast<void>(curve.at_overlap(-1.0)); }), "overlap is -1 m"));
    CHECK(contains(
        input_error_of([&] { static_cast<void>(curve.at_overlap(std::numeric_limits<double>::infinity())); }),
        "overlap is inf m"));
    CHECK(input_error_of([&] { static_cast<void>(curve.sampled(1e-7, 1)); }) ==
          "a curve has 1 points; allowed: at least 2");
    ContactPair wrong = ash(0.3);
    wrong.contact_modulus = 0.0;
    CHECK(contains(input_error_of([&] { static_cast<void>(StaticCurve(Law::of<Dmt>(), wrong)); }),
                   "contact_modulus is 0 Pa"));
    wrong = ash(-0.1);
    CHECK(contains(input_error_of([&] { static_cast<void>(StaticCurve(Law::of<Dmt>(), wrong)); }),
                   "work_of_adhesion is -0.1 J/m2"));
    wrong = ash(0.3);
    wrong.yield_pressure = 2e9;
    CHECK(input_error_of([&] { static_cast<void>(StaticCurve(Law::of<ThorntonNing>(), wrong)); }) ==
          "a contact of law 'thornton-ning' that can yield has no static curve; allowed: an infinite "
          "yield_pressure");
    CHECK(StaticCurve(Law::of<Jkr>(), wrong).at_overlap(1e-8).overlap > 0.0);  // never yields
    wrong = ash(0.3);
    wrong.mass = 0.0;  // a static law has none
    CHECK(StaticCurve(Law::of<Dmt>(), wrong).at_overlap(1e-8).overlap > 0.0);
}
