// SPDX-License-Identifier: GPL-3.0-or-later
// Which detachments end which contacts, why the others do not, and what inputs an impact takes.
#include <cmath>
#include <limits>
#include <string>

#include <doctest/doctest.h>

#include "solver/contact/static_curve.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/errors.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

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
    return input_error_of([&] { static_cast<void>(solve_impact(impact)); });
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
