// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/registry.hpp"

#include <set>
#include <string>

#include <doctest/doctest.h>

#include "solver/damping/damping.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/errors.hpp"

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
    CHECK(input_error_of([] { static_cast<void>(Law::named("JKR")); }) ==
          "no contact law is called \"JKR\", did you mean \"jkr\"?; allowed: " + law_names());
    CHECK(input_error_of([] { static_cast<void>(named<Detachment>("")); }) ==
          "no detachment is called \"\"; allowed: zero-overlap, zero-force, pull-off, load-controlled");
    CHECK(input_error_of([] { static_cast<void>(named<DampingLaw>("viscous")); }) ==
          "no damping law is called \"viscous\"; allowed: constant, contact-radius, tsuji");
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
