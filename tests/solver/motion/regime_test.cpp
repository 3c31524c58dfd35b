// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/regime.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/trajectory.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

Impact impact_with(Law law, double w, double velocity = 2.0) {
    ContactPair pair = ash(w);
    pair.parameters = {};  // no cohesion is stated: the usual range holds
    return impact_of({law, DampingLaw::constant, law.default_detachment()}, pair, 0.3, velocity);
}

bool warns(const Regime& regime, const std::string& part) {
    return std::any_of(regime.warnings.begin(), regime.warnings.end(),
                       [&](const Finding& warning) { return contains(warning.text, part); });
}

Impact impact_with(Law law, double w, double number, double velocity) {
    return impact_of({law, DampingLaw::constant, law.default_detachment()}, ash(w), number, velocity);
}

}  // namespace

TEST_CASE("the numbers of a regime") {
    const Impact impact = impact_with(Law::of<Dmt>(), 0.3);
    const Regime regime = regime_of(impact, 1.1e-7);
    // (R w^2/(E*^2 z0^3))^(1/3) with z0 = 0.4 nm
    const double tabor = std::cbrt(44e-6 * 0.09 / (90e9 * 90e9 * std::pow(0.4e-9, 3)));
    CHECK(relative_difference(regime.tabor_parameter, tabor) < 1e-14);
    CHECK(regime.adhesion == AdhesionRegime::between);
    CHECK(relative_difference(regime.damping_number, 0.3) < 1e-14);
    CHECK(relative_difference(regime.contact_radius, std::sqrt(1.1e-7 * 44e-6)) < 1e-14);
    CHECK(relative_difference(regime.relative_contact_radius, std::sqrt(1.1e-7 / 44e-6)) < 1e-14);
    CHECK(relative_difference(regime.relative_overlap, 1.1e-7 / 44e-6) < 1e-14);
    const double number = 2.0 * std::acos(-1.0) * 0.3 * 44e-6 * std::pow(ash(0.3).mass, -0.6) *
                          std::pow(hertz_stiffness(ash(0.3)), -0.4) * std::pow(2.0, -1.2);
    CHECK(relative_difference(regime.adhesion_number, number) < 1e-13);
    CHECK(!regime.yield_velocity);
    CHECK(!regime.law_yield_velocity);
    CHECK(!regime.yields);
}

TEST_CASE("stated cohesion: one Tabor parameter, whatever states it and whatever the law") {
    Impact impact = impact_with(Law::of<Jkr>(), 0.3);
    ContactPair& pair = impact.contact;
    const double usual = tabor_parameter_of(pair);
    CHECK(relative_difference(transition_parameter_of(pair), 1.157 * usual) < 1e-4);
    const auto judged = [&](const LawParameter& parameter, double value) {
        pair.parameters = {{parameter.name, value}};
        return regime_of(impact, 1e-7);
    };
    for (const Law law : {Law::of<Jkr>(), Law::of<MaugisDugdale>()}) {
        CAPTURE(law.name());
        impact.law = law;
        impact.detachment = law.default_detachment();
        const double stress = 0.5 * cohesive_stress_of_range(0.3, usual_separation);
        for (const Regime& regime : {judged(cohesion_range, 2 * usual_separation),
                                     judged(stated_tabor, usual / 2), judged(cohesive_stress, stress)}) {
            CHECK(relative_difference(regime.tabor_parameter, usual / 2) < 1e-12);
            CHECK(relative_difference(regime.equilibrium_separation, 2 * usual_separation) < 1e-12);
            CHECK(relative_difference(regime.transition_parameter,
                                      transition_per_tabor() * regime.tabor_parameter) < 1e-12);
        }
        CHECK(judged(stated_tabor, 0.05).adhesion == AdhesionRegime::dmt);
        CHECK(judged(stated_tabor, 7.0).adhesion == AdhesionRegime::jkr);
    }
    pair.work_of_adhesion = 0;
    CHECK(tabor_parameter_of(pair) == 0);
    CHECK(judged(cohesion_range, 1e-9).adhesion == AdhesionRegime::none);
}

TEST_CASE("the contact radius is the law's own: JKR's is wider than sqrt(delta R)") {
    for (const Law law : {Law::of<Jkr>(), Law::of<ThorntonNing>()}) {
        CAPTURE(law.name());
        const Impact impact = impact_with(law, 0.3, 0.05);
        const double overlap = solve_impact(impact).maximum_overlap;
        const double a = regime_of(impact, overlap).contact_radius;
        const double back =
            a * a / 44e-6 - std::sqrt(2.0 * std::acos(-1.0) * 0.3 * a / impact.contact.contact_modulus);
        CHECK(relative_difference(back, overlap) < 1e-12);
        CHECK(a > 1.25 * std::sqrt(overlap * 44e-6));
    }
    // At first touch, and where the overlap is none, it is the one of the jump.
    const Impact jkr = impact_with(Law::of<Jkr>(), 0.3);
    const double touch = std::cbrt(2.0 * std::acos(-1.0) * 0.3 * 44e-6 * 44e-6 / 90e9);
    CHECK(relative_difference(regime_of(jkr, 0.0).contact_radius, touch) < 1e-13);
    CHECK(regime_of(impact_with(Law::of<Hertz>(), 0.0), 0.0).contact_radius == 0.0);
}

TEST_CASE("a law outside its range is warned about, with limits and source") {
    // Tabor's parameter goes with w^(2/3): 1.97 at 0.3 J/m2.
    for (const Law law : {Law::of<Dmt>(), Law::of<Jkr>(), Law::of<ThorntonNing>()}) {
        CAPTURE(law.name());
        CHECK(warns(regime_of(impact_with(law, 0.3), 1e-7),
                    "Tabor parameter 1.97 is between DMT (< 0.1) and JKR (> 5) (Johnson & Greenwood 1997)"));
    }
    CHECK(warns(regime_of(impact_with(Law::of<Dmt>(), 3.0), 1e-7), "JKR applies rather than DMT"));
    CHECK(regime_of(impact_with(Law::of<Jkr>(), 3.0), 1e-7).warnings.empty());
    CHECK(warns(regime_of(impact_with(Law::of<Jkr>(), 0.003), 1e-7), "DMT applies rather than JKR"));
    CHECK(regime_of(impact_with(Law::of<Dmt>(), 0.003), 1e-7).warnings.empty());
    CHECK(regime_of(impact_with(Law::of<Jkr>(), 0.0), 1e-7).warnings.empty());
    CHECK(regime_of(impact_with(Law::of<BrachDunn>(), 0.3), 1e-7).warnings.empty());
    CHECK(regime_of(impact_with(Law::of<Jkr>(), 3.0), 1e-7).adhesion == AdhesionRegime::jkr);
    CHECK(regime_of(impact_with(Law::of<Jkr>(), 0.003), 1e-7).adhesion == AdhesionRegime::dmt);
    CHECK(regime_of(impact_with(Law::of<Jkr>(), 0.0), 1e-7).adhesion == AdhesionRegime::none);
    CHECK(name_of(AdhesionRegime::none) == "none");
    CHECK(name_of(AdhesionRegime::dmt) == "dmt");
    CHECK(name_of(AdhesionRegime::between) == "between");
    CHECK(name_of(AdhesionRegime::jkr) == "jkr");
}

TEST_CASE("Hertz is warned about while there is adhesion, with how much it leaves out") {
    const Impact impact = impact_with(Law::of<Hertz>(), 0.3);
    const double overlap = 1.1e-7;
    const double share =
        2.0 * std::acos(-1.0) * 0.3 * 44e-6 / (hertz_stiffness(impact.contact) * std::pow(overlap, 1.5));
    CHECK(std::abs(share - 0.00286) < 1e-5);
    CHECK(warns(regime_of(impact, overlap),
                "leaves out the adhesion of 0.3 J/m2: 2 pi w R* is 0.286 % of the greatest force"));
    CHECK(regime_of(impact_with(Law::of<Hertz>(), 0.0), overlap).warnings.empty());
}

TEST_CASE("the velocity at which a contact just yields, with the adhesion of its law") {
    const double touching = 1e-3;  // well below any overlap here, in units of it
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<Jkr>(), Law::of<ThorntonNing>()}) {
        CAPTURE(law.name());
        Impact impact = impact_with(law, 0.3, 0.5);
        impact.damping.coefficient = 0.0;
        impact.contact.yield_pressure = 2e9;
        const Regime regime = regime_of(impact, 1e-7);
        CHECK(relative_difference(*regime.yield_velocity, yield_velocity(impact.contact)) < 1e-14);
        const double at_yield = *regime.law_yield_velocity;
        const double pressure_excess = [&] {  // of the undamped impact at that velocity, over p_y
            impact.velocity = at_yield;
            const double a = regime_of(impact, solve_impact(impact).maximum_overlap).contact_radius;
            const double tension =
                law == Law::of<Jkr>() || law == Law::of<ThorntonNing>()
                    ? std::sqrt(2.0 * 0.3 * impact.contact.contact_modulus / (std::acos(-1.0) * a))
                    : 0.0;
            return 2.0 * impact.contact.contact_modulus * a / (std::acos(-1.0) * 44e-6) - tension - 2e9;
        }();
        CHECK(std::abs(pressure_excess) < 1e-9 * 2e9);
        for (const double side : {-touching, touching}) {
            impact.velocity = at_yield * (1.0 + side);
            CHECK(regime_of(impact, solve_impact(impact).maximum_overlap).yields == (side > 0.0));
        }
    }
    // An even tension over the contact delays yield by itself.
    Impact even = impact_with(Law::of<Sjkr>(), 0.0, 0.5);
    even.contact.parameters = {{cohesion_energy_density.name, 3e8}};
    even.contact.yield_pressure = 2e9;
    for (const double velocity : {0.5, 0.8, 1.0, 1.2, 1.5, 2.0, 4.0}) {
        even.velocity = velocity;
        const Regime regime = regime_of(even, solve_impact(even).maximum_overlap);
        CHECK(regime.yields == (regime.greatest_pressure > 2e9));
    }
    // DMT pulls itself into yield; a contact that adhesion alone yields has no velocity to wait for.
    Impact impact = impact_with(Law::of<Dmt>(), 0.3);
    impact.contact.yield_pressure = 2e9;
    const Regime dmt = regime_of(impact, 1e-7);
    CHECK(*dmt.law_yield_velocity < *dmt.yield_velocity);
    impact.law = Law::of<Jkr>();
    impact.detachment = Detachment::pull_off;
    impact.contact.yield_pressure = 1e8;
    CHECK(*regime_of(impact, 1e-7).law_yield_velocity == 0.0);
}

TEST_CASE("maugis-dugdale just yields where the undamped impact has the yield pressure in its centre") {
    Impact impact = impact_with(Law::of<MaugisDugdale>(), 0.3, 0.5);
    impact.damping.coefficient = 0.0;
    impact.contact.parameters = ash(0.3).parameters;
    impact.contact.yield_pressure = 2e9;
    const double at_yield = *regime_of(impact, 1e-7).law_yield_velocity;
    // Cohesion pulls the centre less than JKR would, and takes from the pressure of Hertz.
    CHECK(at_yield > 0.5);
    CHECK(at_yield < 1.0);
    for (const double side : {-1e-3, 0.0, 1e-3}) {
        CAPTURE(side);
        impact.velocity = at_yield * (1.0 + side);
        const Regime regime = regime_of(impact, solve_impact(impact).maximum_overlap);
        if (side == 0.0) CHECK(relative_difference(regime.greatest_pressure, 2e9) < 1e-9);
        if (side != 0.0) CHECK(regime.yields == (side > 0.0));
    }
}

TEST_CASE("damping that keeps a contact below yield keeps the warning away") {
    Impact impact = impact_with(Law::of<Hertz>(), 0.0, 0.75);
    impact.contact.yield_pressure = 2e9;  // V_y = 0.676 m/s
    impact.damping.coefficient = 0.0;
    const Regime undamped = regime_of(impact, solve_impact(impact).maximum_overlap);
    CHECK(undamped.yields);
    CHECK(warns(undamped, "the contact yields: velocity 0.75 m/s, yield velocity 0.676 m/s"));
    impact.damping.coefficient =
        Scale::of(impact.contact, 0.75).damping_coefficient(DampingLaw::constant, 0.6);
    const Regime damped = regime_of(impact, solve_impact(impact).maximum_overlap);
    CHECK(!damped.yields);
    CHECK(damped.warnings.empty());
    impact.damping.coefficient = 0.0;
    impact.law = Law::of<ThorntonNing>();
    impact.detachment = Detachment::pull_off;
    const Regime plastic = regime_of(impact, solve_impact(impact).maximum_overlap);
    CHECK(plastic.yields);
    CHECK(plastic.warnings.empty());
}

TEST_CASE("large contacts, overlaps beyond the radius and yield by adhesion alone are warned about") {
    Impact impact = impact_with(Law::of<Hertz>(), 0.0);
    CHECK(warns(regime_of(impact, 5e-6), "contact radius is 0.337 of the radius"));
    CHECK(warns(regime_of(impact, 45e-6), "overlap exceeds the radius: outside the theory"));
    CHECK(regime_of(impact, 3.9e-6).warnings.empty());
    impact = impact_with(Law::of<ThorntonNing>(), 3.0);
    impact.contact.yield_pressure = 1e8;
    CHECK(warns(regime_of(impact, 1e-7), "adhesion alone yields the contact at first touch"));
}

TEST_CASE("velocities at which damping and adhesion are of order one") {
    const ContactPair pair = ash(0.3);
    const Damping damping{DampingLaw::constant, 0.0153};
    const double v_damping = velocity_of_damping(damping, pair);
    CHECK(relative_difference(Scale::of(pair, v_damping).damping_number(damping), 1.0) < 1e-13);
    CHECK(velocity_of_damping({DampingLaw::tsuji, 1.0}, pair) == 0.0);
    CHECK(velocity_of_damping({DampingLaw::contact_radius, 1e3}, pair) == 0.0);
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const double v = velocity_of_adhesion(Law::at(i), pair);
        CAPTURE(Law::at(i).name());
        CHECK(velocity_of_adhesion(Law::at(i), ash(0.0)) == 0.0);
        if (v == 0.0) continue;
        const double number = Law::at(i).visit<double>([&]<template <class> class L>() {
            return L<double>::adhesion_number(pair, Scale::of(pair, v).length);
        });
        CHECK(relative_difference(number, 1.0) < 1e-12);
    }
}

TEST_CASE("each stage's impulses add up to its momentum, Eqs. 36 to 39, to rounding") {
    Worst residual;
    Worst split;
    for (const ContactCase& c : contact_cases()) {
        for (const double number : damping_numbers) {
            const Impact impact = impact_of(c, ash(0.3), number, 2.0);
            const ImpactResult result = solve_impact(impact);
            if (result.outcome == Outcome::capture) continue;
            const MomentumBalance balance = momentum_balance(impact);
            const double momentum = impact.contact.mass * impact.velocity;
            CAPTURE(describe(impact));
            CHECK(relative_difference(balance.incident_momentum, momentum) < 1e-15);
            for (const StageMomentum* stage : {&balance.approach, &balance.rebound}) {
                residual.see(std::abs(stage->residual) / momentum, describe(impact));
                CHECK(relative_difference(stage->mean_force * stage->duration, stage->static_impulse) <
                      1e-14);
                CHECK(stage->damping_impulse > 0.0);
            }
            const double damping = balance.approach.damping_impulse + balance.rebound.damping_impulse;
            split.see(relative_difference(balance.damping_impulse, damping), describe(impact));
            split.see(relative_difference(balance.approach.duration, *result.approach_time),
                      describe(impact));
            split.see(
                relative_difference(balance.rebound.duration, *result.contact_time - *result.approach_time),
                describe(impact));
            split.see(std::abs(balance.momentum_lost - momentum * (1.0 - result.restitution)) / momentum,
                      describe(impact));
        }
    }
    CHECK(residual.count() > 50);
    CHECK_MESSAGE(residual.deviation() < 1e-15, residual.where());
    CHECK_MESSAGE(split.deviation() < 1e-13, split.where());
}

TEST_CASE("the impulses are those of the sampled trajectory, by the trapezoidal rule") {
    for (const ContactCase& c : contact_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const ImpactResult result = solve_impact(impact);
        if (result.outcome == Outcome::capture) continue;
        CAPTURE(describe(impact));
        const MomentumBalance balance = momentum_balance(impact);
        const auto path = trajectory(impact, 4001);
        double contact = 0.0;
        double damping = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const double step = (path[i].time - path[i - 1].time) / 2.0;
            for (const TrajectoryPoint& p : {path[i - 1], path[i]}) {
                contact += step * (p.repulsive_force + p.attractive_force);
                damping += step * std::abs(p.damping_force);
            }
        }
        // Forces have half-integer powers of time at both ends, with Tsuji's damping quarter ones.
        const double both = balance.approach.static_impulse + balance.rebound.static_impulse;
        CHECK(std::abs(contact - both) < 2e-4 * balance.incident_momentum);
        CHECK(std::abs(damping - balance.damping_impulse) < 2e-4 * balance.incident_momentum);
    }
}

TEST_CASE("constant damping: its impulse is eta delta_max in each stage, Eqs. 38 and 39") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        const Impact impact = impact_with(law, 0.3, 0.3, 2.0);
        const MomentumBalance balance = momentum_balance(impact);
        const double expected = impact.damping.coefficient * solve_impact(impact).maximum_overlap;
        CAPTURE(law.name());
        CHECK(relative_difference(balance.approach.damping_impulse, expected) < 1e-14);
        CHECK(relative_difference(balance.rebound.damping_impulse, expected) < 1e-14);
        CHECK(relative_difference(balance.damping_impulse, 2.0 * expected) < 1e-14);
    }
}

TEST_CASE("without adhesion (44) and (45) hold; adhesion that rivals the impact breaks (44), not (45)") {
    for (const double number : {1e-9, 0.05, 0.3, 0.8}) {
        const MomentumBalance balance = momentum_balance(impact_with(Law::of<Hertz>(), 0.0, number, 2.0));
        CAPTURE(number);
        CHECK(balance.damping_exceeds_loss());
        CHECK(balance.rebound_is_longer());
        CHECK(contains(verdict_of(balance), "(44) holds: damping impulse "));
        CHECK(contains(verdict_of(balance), "(45) holds: rebound "));
    }
    const MomentumBalance adhesive = momentum_balance(impact_with(Law::of<Jkr>(), 1.0, 0.005, 0.04));
    CHECK(!adhesive.damping_exceeds_loss());
    CHECK(adhesive.rebound_is_longer());
    CHECK(contains(verdict_of(adhesive), "(44) does not hold: damping impulse "));
}

TEST_CASE("without damping both sides of (44) and (45) are equal, so neither inequality holds") {
    const MomentumBalance balance = momentum_balance(impact_with(Law::of<Hertz>(), 0.0, 0.0, 2.0));
    CHECK(!balance.damping_exceeds_loss());
    CHECK(!balance.rebound_is_longer());
    CHECK(std::abs(balance.mean_force_ratio() - 1.0) < 1e-14);
    CHECK(
        contains(verdict_of(balance), "(45) does not hold: rebound 9.39645e-08 s = 9.39645e-08 s approach"));
    CHECK(contains(verdict_of(balance), "are as 1 to 1"));
}

TEST_CASE("a capture has no balance of a rebound") {
    CHECK(input_error_of(
              [] { static_cast<void>(momentum_balance(impact_with(Law::of<Dmt>(), 0.3, 2.0, 0.5))); }) ==
          "a captured particle has no momentum balance of a rebound; allowed: a velocity above the critical "
          "one");
}
