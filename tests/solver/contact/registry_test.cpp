// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/registry.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "core/quantities/parameter.hpp"
#include "solver/batch/batch.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

TEST_CASE("every registered law is found by its name, and names are unique") {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        CAPTURE(law.name());
        CHECK(!law.name().empty());
        CHECK(Law::named(law.name()) == law);
        CHECK(law.index() == i);
        CHECK(contains(law_names(), std::string(law.name())));
        names.insert(law.name());
    }
    CHECK(names.size() == Law::count());
    CHECK(Law::of<Hertz>().name() == "hertz");
    CHECK(Law::of<Dmt>().name() == "dmt");
    CHECK(Law::of<BrachDunn>().name() == "brach-dunn");
    CHECK(Law::of<Jkr>().name() == "jkr");
    CHECK(Law::of<Jkr>() != Law::of<Hertz>());
}

TEST_CASE("a visitor gets the template of the law it visits") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const auto name =
            Law::at(i).visit<std::string_view>([]<template <class> class L>() { return L<double>::name; });
        CHECK(name == Law::at(i).name());
    }
}

TEST_CASE("unknown names are refused with the known ones") {
    CHECK(input_error_of([] { return Law::named("JKR"); }) ==
          "no contact law is called \"JKR\", did you mean \"jkr\"?; allowed: " + law_names());
    CHECK(input_error_of([] { return named<Detachment>(""); }) ==
          "no detachment is called \"\"; allowed: zero-overlap, zero-force, pull-off, load-controlled");
    CHECK(input_error_of([] { return named<DampingLaw>("viscous"); }) ==
          "no damping law is called \"viscous\"; allowed: constant, contact-radius, tsuji, "
          "hunt-crossley, brach-dunn-damping");
}

TEST_CASE("detachments and damping laws are found by their names") {
    for (const Detachment detachment : all_values<Detachment>) {
        CHECK(named<Detachment>(name_of(detachment)) == detachment);
    }
    for (const DampingLaw damping_law : all_values<DampingLaw>) {
        CHECK(named<DampingLaw>(name_of(damping_law)) == damping_law);
        CHECK(unit_of(damping_law) == si_unit(dimension_of(damping_law)));
    }
    CHECK(name_of(Detachment::zero_overlap) == "zero-overlap");
    CHECK(name_of(Detachment::load_controlled) == "load-controlled");
    CHECK(name_of(DampingLaw::contact_radius) == "contact-radius");
    CHECK(unit_of(DampingLaw::constant) == "kg/s");
    CHECK(unit_of(DampingLaw::contact_radius) == "Pa s");
    CHECK(unit_of(DampingLaw::tsuji) == "1");
}

TEST_CASE("a law's default detachment is admissible: pull-off for JKR, zero overlap for the others") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        CAPTURE(Law::at(i).name());
        CHECK(!refusal(Law::at(i), Law::at(i).default_detachment()));
    }
    CHECK(Law::of<Jkr>().default_detachment() == Detachment::pull_off);
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        CHECK(law.default_detachment() == Detachment::zero_overlap);
    }
}

// Which detachments end which contacts, why the others do not, and what inputs an impact takes.

namespace {

Impact ash_impact(Law law, Detachment detachment) {
    return {.law = law,
            .detachment = detachment,
            .damping = {DampingLaw::constant, 0.005},
            .contact = ash(0.3),
            .velocity = 2.0};
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The message with which an impact is refused that has one field set to @p value.
template <class Set>
std::string refused(double value, Set&& set) {
    Impact impact = ash_impact(Law::of<Dmt>(), Detachment::zero_overlap);
    set(impact, value);
    return input_error_of([&] { return solve_impact(impact); });
}

constexpr LawParameter with_default{.name = "with_default",
                                    .dimension = Dimension::fraction,
                                    .description = "a parameter",
                                    .example = "2",
                                    .typical = 2.0,
                                    .otherwise = 7.0};

Impact sjkr_impact() {
    return {.law = Law::of<Sjkr>(),
            .detachment = Detachment::zero_overlap,
            .damping = {DampingLaw::constant, 0.002},
            .contact = ash(0.0),
            .velocity = 2.0};
}

}  // namespace

TEST_CASE("admissible detachments of each law") {
    CHECK(admissible_detachments(Law::of<Hertz>()) == "zero-overlap, zero-force");
    CHECK(admissible_detachments(Law::of<Dmt>()) == "zero-overlap");
    CHECK(admissible_detachments(Law::of<BrachDunn>()) == "zero-overlap");
    CHECK(admissible_detachments(Law::of<Jkr>()) == "zero-overlap, pull-off, load-controlled");
}

TEST_CASE("a detachment is refused because it would create energy, or because the law has no such point") {
    const std::string energy =
        ": its potential there is below that at first touch, an undamped impact would gain energy";
    const std::string point = ": the law has no such point";
    const auto reason = [](Law law, Detachment detachment) { return refusal(law, detachment).value(); };
    CHECK(reason(Law::of<Dmt>(), Detachment::zero_force) ==
          "zero-force does not end a contact of law dmt" + energy);
    CHECK(reason(Law::of<BrachDunn>(), Detachment::zero_force) ==
          "zero-force does not end a contact of law brach-dunn" + energy);
    CHECK(reason(Law::of<BrachDunn>(), Detachment::load_controlled) ==
          "load-controlled does not end a contact of law brach-dunn" + energy);
    CHECK(reason(Law::of<Jkr>(), Detachment::zero_force) ==
          "zero-force does not end a contact of law jkr" + energy);
    CHECK(reason(Law::of<Hertz>(), Detachment::pull_off) ==
          "pull-off does not end a contact of law hertz" + point);
    CHECK(reason(Law::of<Dmt>(), Detachment::pull_off) ==
          "pull-off does not end a contact of law dmt" + point);
    CHECK(reason(Law::of<Dmt>(), Detachment::load_controlled) ==
          "load-controlled does not end a contact of law dmt" + point);
    CHECK(reason(Law::of<BrachDunn>(), Detachment::pull_off) ==
          "pull-off does not end a contact of law brach-dunn" + point);
    CHECK(reason(Law::of<Hertz>(), Detachment::load_controlled) ==
          "load-controlled does not end a contact of law hertz" + point);
}

TEST_CASE("an impact with a detachment that is refused names the reason and the admissible ones") {
    CHECK(
        input_error_of(
            [] { static_cast<void>(solve_impact(ash_impact(Law::of<Dmt>(), Detachment::zero_force))); }) ==
        "zero-force does not end a contact of law dmt: its potential there is below that at first touch, an "
        "undamped impact would gain energy; allowed: zero-overlap");
    CHECK(input_error_of(
              [] { static_cast<void>(solve_impact(ash_impact(Law::of<Hertz>(), Detachment::pull_off))); }) ==
          "pull-off does not end a contact of law hertz: the law has no such point; "
          "allowed: zero-overlap, zero-force");
}

TEST_CASE("a number out of range is refused with its quantity, value, unit and what is allowed") {
    const auto mass = [](Impact& impact, double value) { impact.contact.mass = value; };
    const auto radius = [](Impact& impact, double value) { impact.contact.effective_radius = value; };
    const auto modulus = [](Impact& impact, double value) { impact.contact.contact_modulus = value; };
    const auto adhesion = [](Impact& impact, double value) { impact.contact.work_of_adhesion = value; };
    const auto velocity = [](Impact& impact, double value) { impact.velocity = value; };
    const auto damping = [](Impact& impact, double value) { impact.damping.coefficient = value; };

    CHECK(refused(-1e-9, mass) == "mass is -1e-09 kg; allowed: a positive mass [kg]");
    CHECK(refused(0.0, radius) == "effective_radius is 0 m; allowed: a positive length [m]");
    CHECK(refused(not_a_number, modulus) == "contact_modulus is nan Pa; allowed: a positive pressure [Pa]");
    CHECK(refused(-0.3, adhesion) ==
          "work_of_adhesion is -0.3 J/m2; allowed: a non-negative energy per area [J/m2]");
    CHECK(refused(-2.0, velocity) == "velocity is -2 m/s; allowed: a positive velocity [m/s]");
    CHECK(refused(-0.0153, damping) == "damping is -0.0153 kg/s; allowed: a non-negative damping [kg/s]");
    for (const double value : {0.0, -1.0, not_a_number, infinity}) {
        CAPTURE(value);
        CHECK(contains(refused(value, mass), "mass is "));
        CHECK(contains(refused(value, radius), "effective_radius is "));
        CHECK(contains(refused(value, modulus), "contact_modulus is "));
        CHECK(contains(refused(value, velocity), "velocity is "));
    }
    for (const double value : {-1.0, not_a_number, infinity}) {
        CAPTURE(value);
        CHECK(contains(refused(value, adhesion), "work_of_adhesion is "));
        CHECK(contains(refused(value, damping), "damping is "));
    }
}

TEST_CASE("a damping out of range is named in the unit of its law") {
    Impact impact = ash_impact(Law::of<Hertz>(), Detachment::zero_overlap);
    impact.damping = {DampingLaw::contact_radius, -3.0};
    CHECK(input_error_of([&] { validate(impact); }) ==
          "damping is -3 Pa s; allowed: a non-negative viscosity [Pa s]");
}

TEST_CASE("values of parameters are found by name; a missing one has its default") {
    ParameterValues<double> values{{"cohesion_energy_density", 3.0}};
    CHECK(values.has(cohesion_energy_density));
    CHECK(values[cohesion_energy_density] == 3.0);
    CHECK_FALSE(values.has(with_default));
    CHECK(values[with_default] == 7.0);
    values.set("with_default", 5.0);
    CHECK(values[with_default] == 5.0);
    values.set("cohesion_energy_density", 4.0);
    CHECK(values[cohesion_energy_density] == 4.0);
    CHECK(std::distance(values.begin(), values.end()) == 2);
    CHECK(std::isnan(ParameterValues<double>()[cohesion_energy_density]));
    values.set("third", 0.0);
    values.set("fourth", 0.0);
    CHECK_THROWS_AS(values.set("fifth", 0.0), std::logic_error);
}

TEST_CASE("every declared parameter is consistent, and one pair has room for those of all laws") {
    for (const LawParameter& parameter : law_parameters()) {
        CAPTURE(parameter.name);
        CHECK(parse_quantity(parameter.example, parameter.dimension) == doctest::Approx(parameter.typical));
        CHECK_NOTHROW(require_allowed(parameter, parameter.typical));
        for (std::size_t i = 0; i < Law::count(); ++i)
            for (const LawParameter& other : Law::at(i).parameters())
                if (other.name == parameter.name) CHECK(other.dimension == parameter.dimension);
    }
    CHECK_NOTHROW(static_cast<void>(parameters_like(0.3)));
}

TEST_CASE("an impact without a parameter of its law, or with one out of bounds, is refused") {
    Impact impact = sjkr_impact();
    impact.contact.parameters = {};
    CHECK(
        input_error_of([&] { return solve_impact(impact); }) ==
        "cohesion_energy_density is missing; allowed: k_c, cohesion energy per volume (J/m3 is Pa), such as "
        "\"100 MJ/m3\"");
    for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        impact.contact.parameters = {{"cohesion_energy_density", wrong}};
        CHECK(contains(input_error_of([&] { return solve_impact(impact); }), "cohesion_energy_density is "));
    }
    impact.contact.parameters = {{"cohesion_energy_density", 0.0}};
    CHECK_NOTHROW(static_cast<void>(solve_impact(impact)));
}

TEST_CASE("a batch takes a parameter as a column or as a single value, and refuses what an impact refuses") {
    const Impact impact = sjkr_impact();
    const Eigen::ArrayXd mass = Eigen::ArrayXd::Constant(1, impact.contact.mass);
    const Eigen::ArrayXd radius = Eigen::ArrayXd::Constant(1, impact.contact.effective_radius);
    const Eigen::ArrayXd modulus = Eigen::ArrayXd::Constant(1, impact.contact.contact_modulus);
    const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(1);
    const Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(1, impact.damping.coefficient);
    const Eigen::ArrayXd velocity = Eigen::ArrayXd::Constant(1, impact.velocity);
    Eigen::ArrayXd density(3);
    density << 1e6, 1e7, 1e8;
    const auto solved = [&](const Eigen::ArrayXd& values) {
        return solve_impacts(
            {impact.law,
             impact.detachment,
             impact.damping.law,
             {mass, radius, modulus, none, never_yields, {{"cohesion_energy_density", values}}},
             damping,
             velocity});
    };
    const ImpactBatchResult result = solved(density);
    REQUIRE(result.restitution.size() == 3);
    for (Eigen::Index i = 0; i < 3; ++i) {
        Impact alone = impact;
        alone.contact.parameters = {{"cohesion_energy_density", density[i]}};
        CHECK(std::abs(result.restitution[i] - solve_impact(alone).restitution) < 1e-12);
    }
    CHECK(solved(Eigen::ArrayXd::Constant(1, 1e7)).restitution[0] == result.restitution[1]);
    density[1] = -1.0;
    CHECK(contains(input_error_of([&] { return solved(density); }),
                   "impact 1: cohesion_energy_density is -1 Pa"));
    CHECK(contains(input_error_of([&] {
                       return solve_impacts({impact.law,
                                             impact.detachment,
                                             impact.damping.law,
                                             {mass, radius, modulus, none},
                                             damping,
                                             velocity});
                   }),
                   "cohesion_energy_density is missing"));
}
