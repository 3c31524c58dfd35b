// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/present/export/subject.hpp"
#include "solver/contact/sjkr.hpp"
#include "tests/exports/ash.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

ExportSubject sizes(ExportSubject subject, double from, double to, double exponent) {
    subject.from_diameter = from;
    subject.to_diameter = to;
    subject.damping.exponent = exponent;
    return subject;
}

/// Largest |de| of a table over random impacts, half of them close to v_c.
double worst_error(const ExportSubject& subject, const ImpactTable& table) {
    std::mt19937_64 random(20261122);
    std::uniform_real_distribution<double> share(0, 1);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const double d =
            subject.from_diameter * std::pow(subject.to_diameter / subject.from_diameter, share(random));
        const double start = start_velocity(table, d);
        const double excess =
            i % 2 == 0 ? std::pow(10, -6 * share(random)) : table.to_velocity / start * share(random);
        const double v = start * (1 + excess);
        if (v > table.to_velocity || v < table.from_velocity) continue;
        const double e = solve_impact(impact_at(subject, d, v)).restitution;
        worst = std::max(worst, std::abs(e - restitution(table, d, v)));
    }
    return worst;
}

}  // namespace

TEST_CASE("a table gives the restitution within 2e-4 at any velocity and size") {
    for (const char* law : {"hertz", "dmt", "brach-dunn", "jkr"}) {
        CAPTURE(law);
        for (const double exponent : {0.0, 2.0}) {
            CAPTURE(exponent);
            const ExportSubject subject = sizes(ash(law), 60e-6, 130e-6, exponent);
            const ImpactTable table = make_impact_table(subject);
            CHECK(table.captures);
            CHECK(table.largest_error < table_accuracy);
            CHECK(worst_error(subject, table) < table_accuracy);
        }
    }
}

TEST_CASE("a table has the critical velocity of every size") {
    for (const ExportSubject& subject :
         {sizes(ash("brach-dunn"), 5e-6, 200e-6, 1.5), sizes(ash("jkr"), 60e-6, 130e-6, 0)}) {
        CAPTURE(subject.law.name());
        const ImpactTable table = make_impact_table(subject);
        const double span = subject.to_diameter / subject.from_diameter;
        for (int i = 0; i < std::log(span) / std::log(1.0137); ++i) {
            const double d = subject.from_diameter * std::pow(1.0137, i);
            CHECK(relative_difference(start_velocity(table, d), *threshold_at(subject, d).value) <
                  table_threshold_accuracy);
        }
    }
}

TEST_CASE("a table of impacts without capture starts at its smallest velocity") {
    ExportSubject subject = ash("hertz");
    subject.damping = {.law = DampingLaw::contact_radius, .nodes = {{0, 300.0}}, .reference_diameter = 88e-6};
    const ImpactTable table = make_impact_table(subject);
    CHECK_FALSE(table.captures);
    CHECK(table.from_velocity == doctest::Approx(table.to_velocity / 1000));
    CHECK(worst_error(subject, table) < table_accuracy);
}

TEST_CASE("damping that follows the velocity moves the threshold to where both agree") {
    ExportSubject subject = ash("dmt");
    const double at_rest = *threshold_at(subject, 88e-6).value;
    subject.damping.nodes = {{at_rest, 0.0141}, {2 * at_rest, 0.010}, {6 * at_rest, 0.007}};
    subject.to_velocity = 6 * at_rest;
    CHECK(relative_difference(*threshold_at(subject, 88e-6).value, at_rest) < 1e-9);
    const ImpactTable table = make_impact_table(subject);
    CHECK(worst_error(subject, table) < table_accuracy);
}

TEST_CASE("a table of a law with a parameter of its own has that parameter in its impacts") {
    ExportSubject subject = ash("sjkr");
    subject.contact.parameters = {{cohesion_energy_density.name, 2e9}};
    const ImpactTable table = make_impact_table(subject);
    CHECK(worst_error(subject, table) < table_accuracy);
    const double strong = table.start_velocity.front();
    subject.contact.parameters = {{cohesion_energy_density.name, 0.0}};
    CHECK(strong > 1.1 * make_impact_table(subject).start_velocity.front());
}

TEST_CASE("what a table cannot hold is refused") {
    ExportSubject captured = ash("hertz");
    captured.damping = {.law = DampingLaw::tsuji, .nodes = {{0, 3.0}}, .reference_diameter = 88e-6};
    CHECK_THROWS_AS(static_cast<void>(make_impact_table(captured)), InputError);
    ExportSubject slow = ash("dmt");
    slow.to_velocity = 1e-3;
    CHECK_THROWS_AS(static_cast<void>(make_impact_table(slow)), InputError);
    CHECK_THROWS_AS(static_cast<void>(make_impact_table(sizes(ash("dmt"), 1e-9, 1, 0))), InputError);
    ExportSubject followed = sizes(ash("dmt"), 60e-6, 88e-6, 2);
    followed.damping.nodes = {{1, 0.014}, {2, 0.01}};
    followed.to_velocity = 2;
    CHECK_THROWS_WITH_AS(static_cast<void>(make_impact_table(followed)), doctest::Contains("steeply"),
                         InputError);
}

}  // namespace ashimpact::test
