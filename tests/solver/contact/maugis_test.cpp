// SPDX-License-Identifier: GPL-3.0-or-later
// The static law of Maugis and Dugdale: its equations as printed, its limits, its energies and pressures.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/quadrature.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

namespace numbers = std::numbers;
constexpr double maugis_lambdas[] = {0.01, 0.05, 0.2, 0.5, 0.7, 0.93, 0.95, 1.5, 5.0, 50.0, 1000.0};

/// Stable touching states, from the edge of the branch inwards.
template <class Visit>
void for_each_stable_state(const CohesiveZone& zone, Visit&& visit) {
    const Extended edge = zone.pull_off().angle;
    for (int i = 1; i < 200; ++i) visit(zone.at_angle(edge * std::pow(0.95L, static_cast<Extended>(i))));
}

double force_of(const CohesiveZone& zone, const CohesiveState& state) {
    return static_cast<double>(zone.force(state));
}

}  // namespace

TEST_CASE("states solve Maugis' equations as printed, in m = c/a") {
    for (const double lambda : maugis_lambdas) {
        CAPTURE(lambda);
        const CohesiveZone zone(lambda);
        const Extended l = lambda;
        Extended worst = 0;
        int seen = 0;
        for_each_stable_state(zone, [&](const CohesiveState& state) {
            if (state.angle < 2e-3L) return;  // the printed forms cancel
            ++seen;
            const Extended a = state.contact_radius();
            const Extended m = state.cohesive_radius / a;
            const Extended s = std::tan(state.angle);
            const Extended theta = std::acos(1 / m);
            const Extended one = l * a * a / 2 * (s + (m * m - 2) * state.angle) +
                                 4 * l * l * a / 3 * (s * state.angle - m + 1);
            const Extended overlap = a * a - 4 * l / 3 * a * s;
            const Extended total = a * a * a - l * a * a * (s + m * m * state.angle);
            worst = std::max(worst, std::abs(one - 1));
            worst = std::max(worst, std::abs(zone.overlap(state) - overlap) / (a * a + 1));
            worst = std::max(worst, std::abs(zone.force(state) - total) / (a * a * a + 2));
            worst = std::max(worst, std::abs(theta - state.angle));
        });
        CHECK(worst < 1e-11);
        CHECK((seen > 10 || lambda > 100.0));
    }
}

TEST_CASE("the force is the slope of the potential, and stiffness rises all along the stable branch") {
    for (const double lambda : maugis_lambdas) {
        CAPTURE(lambda);
        const CohesiveZone zone(lambda);
        Extended worst = 0;
        Extended softer = -std::numeric_limits<Extended>::infinity();
        int rises = 0;
        for_each_stable_state(zone, [&](const CohesiveState& state) {
            const CohesiveState in = zone.at_angle(state.angle * (1 - 1e-6L));
            const CohesiveState out = zone.at_angle(state.angle * (1 + 1e-6L));
            const Extended way = zone.overlap(in) - zone.overlap(out);
            const Extended work = zone.potential(in) - zone.potential(out);
            const Extended size = std::abs(zone.force(state)) + 1;
            worst = std::max(worst, std::abs(work / way - zone.force(state)) / size);
            const Extended stiffness = zone.stiffness(state);  // from the fold inwards
            rises += stiffness > softer ? 1 : 0;
            softer = stiffness;
            CHECK(zone.at_contact_radius(state.contact_radius()).angle ==
                  doctest::Approx(static_cast<double>(state.angle)).epsilon(1e-15));
        });
        CHECK(worst < 1e-8);
        CHECK(rises == 199);
    }
}

TEST_CASE("gap and contact meet in overlap, force and potential") {
    for (const double lambda : maugis_lambdas) {
        CAPTURE(lambda);
        const CohesiveZone zone(lambda);
        const Extended c = zone.join().cohesive_radius;
        CHECK(relative_difference(static_cast<double>(zone.gap_overlap()(c)),
                                  static_cast<double>(zone.overlap(zone.join()))) < 1e-14);
        CHECK(relative_difference(static_cast<double>(zone.gap_force()(c)), force_of(zone, zone.join())) <
              1e-14);
        const auto potential =
            static_cast<double>(lambda * c * c * c * (4 * lambda / 9.0L - numbers::pi * c / 8));
        CHECK(std::abs(static_cast<double>(zone.potential(zone.join())) - potential) < 1e-13);
    }
}

TEST_CASE("the jump in ends in contact for lambda > 0.655, the fold lies in contact for lambda > 0.938") {
    CHECK(!CohesiveZone(0.654L).touch().touching());
    CHECK(CohesiveZone(0.656L).touch().touching());
    CHECK(!CohesiveZone(0.937L).pull_off().touching());
    CHECK(CohesiveZone(0.939L).pull_off().touching());
}

TEST_CASE("the state at an overlap has this overlap, in the gap and in contact") {
    for (const Extended lambda : {0.05L, 0.3L, 0.6L, 0.9L, 0.95L, 3.0L}) {
        const CohesiveZone zone(lambda);
        const Extended first = zone.overlap(zone.pull_off());
        const Extended join = zone.overlap(zone.join());
        for (const Extended share : {0.001L, 0.3L, 0.7L, 0.999L, 1.001L, 2.0L, 10.0L}) {
            const Extended overlap = first + share * std::abs(join - first);
            const CohesiveState state = zone.at_overlap(overlap);
            CAPTURE(static_cast<double>(lambda));
            CAPTURE(static_cast<double>(share));
            CHECK(state.touching() == (overlap > join || zone.pull_off().touching()));
            CHECK(std::abs(static_cast<double>(zone.overlap(state) - overlap)) <
                  1e-14 * static_cast<double>(std::abs(first) + std::abs(overlap)));
        }
    }
}

TEST_CASE("pull-off runs from -2 pi w R to -1.5 pi w R, within 2 % of Carpick, Ogletree & Salmeron 1999") {
    double before = -2.0;
    for (int i = 0; i < 62; ++i) {
        const double lambda = 1e-3 * std::pow(1.3, i);
        CAPTURE(lambda);
        const CohesiveZone zone(lambda);
        const double tension = force_of(zone, zone.greatest_tension());
        CHECK(tension > before);
        CHECK(tension > -2.0);
        CHECK(tension < -1.5);
        CHECK(relative_difference(-tension, carpick_pull_off(lambda)) < 0.02);
        before = tension;
    }
    CHECK(relative_difference(force_of(CohesiveZone(1e-3L), CohesiveZone(1e-3L).greatest_tension()), -2.0) <
          1e-3);
    CHECK(relative_difference(force_of(CohesiveZone(1e4L), CohesiveZone(1e4L).greatest_tension()), -1.5) <
          1e-6);
}

TEST_CASE("contact radius at zero load and at pull-off tend to Maugis' limits") {
    const auto radius = [](const CohesiveState& state) {
        return static_cast<double>(state.contact_radius());
    };
    const CohesiveZone soft(1e4L);
    const CohesiveZone hard(1e-4L);
    CHECK(relative_difference(radius(soft.equilibrium()), std::cbrt(6.0)) < 1e-5);
    CHECK(relative_difference(radius(soft.greatest_tension()), std::cbrt(1.5)) < 1e-4);
    CHECK(relative_difference(radius(soft.pull_off()), std::cbrt(1.0 / 6.0)) < 1e-5);
    CHECK(relative_difference(radius(hard.equilibrium()), std::cbrt(2.0)) < 2e-3);
    CHECK(radius(hard.greatest_tension()) < 1e-3);
}

TEST_CASE("the work of separation runs from that of DMT, none, to that of JKR, and the fit keeps its word") {
    ContactPair pair = ash(0.3);
    const double jkr = separation_energy({.work_of_adhesion = 0.3,
                                          .effective_radius = pair.effective_radius,
                                          .contact_modulus = pair.contact_modulus});
    double before = 0.0;
    double worst = 0.0;
    for (int i = 0; i < 698; ++i) {
        const double lambda = 0.01 * std::pow(1.02, i);
        const double energy = cohesive_separation_energy(pair, lambda);
        CHECK(energy > before);
        CHECK(energy < jkr);
        worst = std::max(worst, relative_difference(fitted_energy_ratio(lambda) * jkr, energy));
        before = energy;
    }
    CHECK(worst < fitted_energy_error);
    CHECK(relative_difference(cohesive_separation_energy(pair, 1e5), jkr) < 1e-5);
    // Both jumps in the gap: W is a pure power.
    const double power = 8704.0 / (243.0 * numbers::pi * numbers::pi * numbers::pi);
    for (const double lambda : {0.05, 0.3, 0.65})
        CHECK(relative_difference(static_cast<double>(CohesiveZone(lambda).separation_energy()),
                                  power * std::pow(lambda, 5)) < 1e-13);
    const double velocity = cohesive_separation_velocity(pair, 2.0);
    CHECK(relative_difference(0.5 * pair.mass * velocity * velocity, cohesive_separation_energy(pair, 2.0)) <
          1e-14);
}

TEST_CASE("Tabor parameter, cohesive stress and range say the same") {
    ContactPair pair = ash(0.3);
    const double mu = tabor_parameter({.work_of_adhesion = 0.3,
                                       .effective_radius = pair.effective_radius,
                                       .contact_modulus = pair.contact_modulus},
                                      0.4e-9);
    const double stress = cohesive_stress_of_range(0.3, 0.4e-9);
    const auto lambda_with = [&](const LawParameter& parameter, double value) {
        pair.parameters = {{parameter.name, value}};
        return transition_parameter(pair);
    };
    CHECK(relative_difference(transition_per_tabor(), 1.157) < 1e-4);
    CHECK(relative_difference(lambda_with(stated_tabor, mu), lambda_with(cohesive_stress, stress)) < 1e-14);
    CHECK(relative_difference(lambda_with(stated_tabor, mu), lambda_with(cohesion_range, 0.4e-9)) < 1e-14);
    CHECK_THROWS_AS(static_cast<void>(lambda_with(stated_tabor, 1e9)), InputError);
    CHECK_THROWS_AS(static_cast<void>(lambda_with(stated_tabor, 1e-7)), InputError);
}

TEST_CASE("load-controlled ends a contact of short reach alone, zero force none") {
    CHECK(!cohesive_refusal(CohesiveZone(1.37L), Detachment::load_controlled));
    CHECK(cohesive_refusal(CohesiveZone(1.36L), Detachment::load_controlled));
    CHECK(!cohesive_refusal(CohesiveZone(0.1L), Detachment::zero_overlap));
    CHECK(!cohesive_refusal(CohesiveZone(0.1L), Detachment::pull_off));
    CHECK(cohesive_refusal(CohesiveZone(2.0L), Detachment::zero_force));
}

TEST_CASE("pressures integrate to the force: Hertz Eq. 8, JKR Eq. 19, Maugis-Dugdale") {
    ContactPair pair = ash(0.3);
    const auto total = [](const PressureProfile& p) {
        // r = a sqrt(1 - y^2) takes away the root and the pole at the rim.
        const double a = p.contact_radius;
        const double inner = integral(
            [&](double y) { return 2 * numbers::pi * a * a * y * p.at(a * std::sqrt((1 - y) * (1 + y))); },
            0.0, 1.0, numbers::pi * a * a * p.hertz_pressure);
        const double outer = p.outer_radius * p.outer_radius - a * a;
        return inner - numbers::pi * p.cohesive_stress * outer;
    };
    for (const double a : {0.4e-6, 1.1e-6, 3e-6}) {
        CAPTURE(a);
        const double hertz = 4.0 / 3.0 * pair.contact_modulus * a * a * a / pair.effective_radius;
        const double rim = std::sqrt(8 * numbers::pi * 0.3 * pair.contact_modulus * a * a * a);
        CHECK(relative_difference(hertz_pressure(pair, a).force(), hertz) < 1e-14);
        CHECK(relative_difference(total(hertz_pressure(pair, a)), hertz) < 1e-12);
        CHECK(std::abs(jkr_pressure(pair, a).force() - (hertz - rim)) < 1e-14 * (hertz + rim));
        CHECK(std::abs(total(jkr_pressure(pair, a)) - (hertz - rim)) < 1e-12 * (hertz + rim));
        pair.parameters = {{cohesion_energy_density.name, 1e8}};
        const PressureProfile even = Law::of<Sjkr>().pressure(pair, a);
        const double area = numbers::pi * a * a;
        CHECK(std::abs(even.force() - (hertz - 1e8 * area)) < 1e-14 * hertz);
        CHECK(std::abs(total(even) - (hertz - 1e8 * area)) < 1e-12 * hertz);
        CHECK(relative_difference(even.central(), hertz_pressure(pair, a).central() - 1e8) < 1e-14);
        CHECK(std::abs(StaticCurve(Law::of<Sjkr>(), pair).at_contact_radius(a).force() - even.force()) <
              1e-12 * hertz);
        for (const double lambda : {0.3, 2.0, 30.0}) {
            const PressureProfile profile = maugis_dugdale_pressure(pair, lambda, a);
            const MaugisUnits units = maugis_units(pair);
            const CohesiveZone zone(lambda);
            const double expected = force_of(zone, zone.at_contact_radius(a / units.radius)) * units.force;
            CHECK(std::abs(profile.force() - expected) < 1e-12 * (hertz + rim));
            CHECK(std::abs(total(profile) - expected) < 1e-12 * (hertz + rim));
        }
        // Short of reach the profile is that of JKR, but for the rim.
        CHECK(relative_difference(maugis_dugdale_pressure(pair, 1e4, a).central(),
                                  jkr_pressure(pair, a).central()) < 1e-3);
    }
    // Eqs. 4 and 5: p_0 = (2/numbers::pi) E* sqrt(delta/R*).
    const double delta = 1e-7;
    CHECK(relative_difference(
              hertz_pressure(pair, std::sqrt(pair.effective_radius * delta)).central(),
              2 / numbers::pi * pair.contact_modulus * std::sqrt(delta / pair.effective_radius)) < 1e-14);
}

TEST_CASE("the static curve of maugis-dugdale tends to that of JKR") {
    ContactPair pair = ash(0.3);
    const StaticCurve jkr(Law::of<Jkr>(), pair);
    const auto distance = [&](double mu) {
        pair.parameters = {{stated_tabor.name, mu}};
        const StaticCurve curve(Law::of<MaugisDugdale>(), pair);
        double worst = 0.0;
        for (const double a : {1.0e-6, 2e-6})
            worst = std::max(worst, relative_difference(curve.at_contact_radius(a).force(),
                                                        jkr.at_contact_radius(a).force()));
        return worst;
    };
    CHECK(distance(100.0) < 0.02);
    CHECK(distance(1000.0) < 0.2 * distance(100.0));
    pair.parameters = {{stated_tabor.name, 0.2}};
    const StaticCurve hard(Law::of<MaugisDugdale>(), pair);
    CHECK(hard.first().contact_radius == 0.0);  // it breaks across the gap
    CHECK(hard.first().overlap < 0.0);
}

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
    CHECK(contains(input_error_of([&] { return curve.at_contact_radius(1e-8); }),
                   "contact_radius is 1e-08 m; allowed: "));
    CHECK(contains(input_error_of([&] { return curve.at_overlap(-1.0); }), "overlap is -1 m"));
    CHECK(contains(input_error_of([&] { return curve.at_overlap(std::numeric_limits<double>::infinity()); }),
                   "overlap is inf m"));
    CHECK(input_error_of([&] { return curve.sampled(1e-7, 1); }) ==
          "a curve has 1 points; allowed: at least 2");
    ContactPair wrong = ash(0.3);
    wrong.contact_modulus = 0.0;
    CHECK(contains(input_error_of([&] { return StaticCurve(Law::of<Dmt>(), wrong); }),
                   "contact_modulus is 0 Pa"));
    wrong = ash(-0.1);
    CHECK(contains(input_error_of([&] { return StaticCurve(Law::of<Dmt>(), wrong); }),
                   "work_of_adhesion is -0.1 J/m2"));
    wrong = ash(0.3);
    wrong.yield_pressure = 2e9;
    CHECK(input_error_of([&] { return StaticCurve(Law::of<ThorntonNing>(), wrong); }) ==
          "a contact of law 'thornton-ning' that can yield has no static curve; allowed: an infinite "
          "yield_pressure");
    CHECK(StaticCurve(Law::of<Jkr>(), wrong).at_overlap(1e-8).overlap > 0.0);  // never yields
    wrong = ash(0.3);
    wrong.mass = 0.0;  // a static law has none
    CHECK(StaticCurve(Law::of<Dmt>(), wrong).at_overlap(1e-8).overlap > 0.0);
}

TEST_CASE("Eq. 15 with both signs: the radii of a JKR contact under a force") {
    const ContactPair pair = ash(0.3);
    const StaticCurve curve(Law::of<Jkr>(), pair);
    const double tension = numbers::pi * 0.3 * pair.effective_radius;
    const double unit = std::cbrt(tension * pair.effective_radius / (4.0 / 3.0 * pair.contact_modulus));
    for (const double force : {10.0, 0.0, -0.5, -0.84, -1.0, -1.4999}) {
        CAPTURE(force);
        const auto radii = jkr_radii(pair, force * tension);
        REQUIRE(radii.size() == (force < -5.0 / 6.0 ? 2 : 1));
        for (const double a : radii)
            CHECK(std::abs(curve.at_contact_radius(a).force() / tension - force) < 1e-11);
        CHECK(std::pow(radii[0] / unit, 3) >= 1.5);
        if (radii.size() == 2) CHECK(std::pow(radii[1] / unit, 3) < 1.5);
    }
    // At the fold + gives 25/6 and - gives 1/6.
    const auto fold = jkr_radii(pair, std::nextafter(-5.0 / 6.0 * tension, -1.0));
    REQUIRE(fold.size() == 2);
    CHECK(std::pow(fold[0] / unit, 3) == doctest::Approx(25.0 / 6.0).epsilon(1e-12));
    CHECK(std::pow(fold[1] / unit, 3) == doctest::Approx(1.0 / 6.0).epsilon(1e-12));
    CHECK(jkr_radii(pair, -1.51 * tension).empty());
    // The pressure changes sign at r_c; q_0 = 1 where it pulls everywhere.
    const PressureProfile profile = jkr_pressure(pair, fold[0]);
    const double neutral = profile.neutral_radius();
    CHECK(profile.at(neutral * (1 - 1e-9)) > 0);
    CHECK(profile.at(neutral * (1 + 1e-9)) < 0);
    CHECK(hertz_pressure(pair, 1e-6).neutral_radius() == 1e-6);
    CHECK(jkr_pressure(pair, 0.3 * unit).neutral_radius() == 0);
}
