// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>
#include <regex>
#include <string>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/present/export/folder.hpp"
#include "pipeline/present/export/subject.hpp"
#include "solver/contact/sjkr.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

/// Fly ash of 88 um with constant damping.
ExportSubject ash(std::string_view law_name) {
    const Law law = Law::named(law_name);
    return {.law = law,
            .detachment = law.default_detachment(),
            .contact = {.mass = sphere_mass(44e-6, 2600),
                        .effective_radius = 44e-6,
                        .contact_modulus = 90e9,
                        .work_of_adhesion = 0.3},
            .density = 2600,
            .damping = {.law = DampingLaw::constant, .nodes = {{0, 0.0141}}, .reference_diameter = 88e-6},
            .from_diameter = 88e-6,
            .to_diameter = 88e-6};
}

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

const std::string& content(const ExportFolder& folder, std::string_view name) {
    const auto found = std::ranges::find(folder, name, &ExportFile::name);
    REQUIRE(found != folder.end());
    return found->content;
}

/// Two equal spheres of ash.
ExportSubject two_spheres(std::string_view law) {
    ExportSubject subject = ash(law);
    subject.partner = PartnerBody{.radius = 44e-6, .mass = sphere_mass(44e-6, 2600)};
    subject.contact.effective_radius /= 2;
    subject.contact.mass /= 2;
    return subject;
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

TEST_CASE("damping goes with the size and along its nodes") {
    const SizedDamping damping{.law = DampingLaw::constant,
                               .nodes = {{1, 4.0}, {2, 2.0}, {4, 1.0}},
                               .reference_diameter = 2,
                               .exponent = 2};
    CHECK(damping.coefficient(2, 0.5) == 4.0);
    CHECK(damping.coefficient(2, 1.5) == 3.0);
    CHECK(damping.coefficient(2, 3) == 1.5);
    CHECK(damping.coefficient(2, 9) == 1.0);
    CHECK(damping.coefficient(4, 1.5) == 12.0);
    CHECK(damping.depends_on_velocity());
}

TEST_CASE("damping that goes with the square of the size keeps the critical velocity of Hertz spheres") {
    ExportSubject subject = ash("hertz");
    subject.damping.exponent = 2;
    CHECK(relative_difference(*threshold_at(subject, 20e-6).value, *threshold_at(subject, 88e-6).value) <
          1e-12);
}

TEST_CASE("expected impacts lie on both sides of the critical velocity") {
    ExportSubject subject = ash("dmt");
    subject.from_diameter = 60e-6;
    subject.damping.exponent = 2;
    subject.velocity = 2.345;
    int captures = 0;
    int own = 0;
    for (const ExpectedImpact& each : expected_impacts(subject)) {
        const bool below = each.velocity < *threshold_at(subject, each.diameter).value;
        CHECK((each.outcome == Outcome::capture) == below);
        CHECK((each.restitution > 0) != below);
        captures += below ? 1 : 0;
        own += each.velocity == 2.345 ? 1 : 0;
    }
    CHECK(captures >= 3);
    CHECK(own == 3);
}

TEST_CASE("a partner gives R* and m* of both spheres, at every size; a large one is the wall") {
    const ExportSubject wall = ash("dmt");
    ExportSubject subject = wall;
    subject.partner = PartnerBody{.radius = 30e-6, .mass = 9e-10};
    const ContactPair contact = contact_at(subject, 60e-6);
    CHECK(relative_difference(contact.effective_radius, 15e-6) < 1e-14);
    const double mass = sphere_mass(30e-6, 2600);
    CHECK(relative_difference(particle_mass(subject, 60e-6), mass) < 1e-14);
    CHECK(relative_difference(contact.mass, mass * 9e-10 / (mass + 9e-10)) < 1e-14);
    subject.partner = PartnerBody{.radius = 44, .mass = 1};
    CHECK(relative_difference(*threshold_at(subject, 60e-6).value, *threshold_at(wall, 60e-6).value) < 1e-4);
    subject.partner = PartnerBody{.radius = 44e3, .mass = 1e3};
    CHECK(relative_difference(*threshold_at(subject, 60e-6).value, *threshold_at(wall, 60e-6).value) < 1e-7);
}

TEST_CASE("a code refuses what it cannot do, with the reason") {
    const auto refused = [](ExportFolder (*folder)(const ExportSubject&, const TableImage&),
                            const ExportSubject& subject, const std::string& reason) {
        CHECK(contains(input_error_of([&] { return folder(subject, {}); }), reason));
    };
    refused(lammps_folder, ash("jkr"), "NaN for JKR on a wall");
    refused(lammps_folder, ash("thornton-ning"), "thornton-ning");
    refused(liggghts_folder, ash("jkr"), "sjkr");
    ExportSubject two = two_spheres("brach-dunn");
    refused(lammps_folder, two, "knows no brach-dunn");
    refused(openfoam_folder, two, "no second sphere");
    refused(fluent_folder, two, "no second sphere");
    refused(lammps_folder, two_spheres("jkr"), "load-controlled");
    refused(liggghts_folder, two_spheres("jkr"), "knows no jkr");
    two = two_spheres("dmt");
    two.from_diameter = 60e-6;
    refused(liggghts_folder, two, "edinburgh");
    two.damping.exponent = 2;
    refused(lammps_folder, two, "--damping-exponent 0");
    ExportSubject tsuji = ash("dmt");
    tsuji.damping = {.law = DampingLaw::tsuji, .nodes = {{0, 0.5}}, .reference_diameter = 88e-6};
    refused(yade_folder, tsuji, "`en` with `gamma`");
    ExportSubject followed = ash("dmt");
    followed.damping.nodes = {{1, 0.014}, {2, 0.01}};
    refused(yade_folder, followed, "velocity of approach");
    ExportSubject zero_force = ash("hertz");
    zero_force.detachment = Detachment::zero_force;
    refused(lammps_folder, zero_force, "let go");
}

TEST_CASE("inputs carry the conversions of the code") {
    const ExportFolder lammps = lammps_folder(ash("dmt"));
    CHECK(contains(content(lammps, "ash_wall.in"), "dmt 180000000000 0.0141"));
    CHECK(contains(content(lammps, "ash_wall.in"), " 0.14999999999999999 tangential"));
    const ExportFolder liggghts = liggghts_folder(ash("brach-dunn"));
    CHECK(contains(content(liggghts, "ash_material.in"), "youngsModulus peratomtype 180000000000"));
    ExportSubject broken = two_spheres("jkr");
    broken.detachment = Detachment::load_controlled;
    const ExportFolder pair = lammps_folder(broken);
    CHECK(contains(content(pair, "ash_pair.in"), "jkr 180000000000 0.0141 0 0.14999999999999999"));
    CHECK(contains(content(pair, "expected.json"), "\"end\": \"free-flight\""));
    CHECK(contains(content(pair, "in.impacts"), "equal z[1]-z[2]"));
    // -2 pi w R*, R* = 22 um
    CHECK(contains(content(liggghts_folder(two_spheres("dmt")), "ash_pair.in"), " -4.1469023027385"));
    CHECK(contains(content(openfoam_folder(ash("jkr")), "ashSolver"), "law             jkr;"));
    for (const ExportFolder& folder : {lammps, liggghts, yade_folder(ash("dmt")), fluent_folder(ash("jkr"))})
        for (const ExportFile& file : folder) {
            CAPTURE(file.name);
            CHECK_FALSE(contains(file.name, ".."));
            CHECK_FALSE(file.content.empty());
        }
}

TEST_CASE("a softened folder has the impacts of the stiff contact, and constants that follow E*") {
    ExportSubject stiff = ash("dmt");
    stiff.to_velocity = 2;
    const ExportSubject soft = softened(stiff, 1000);
    CHECK(stretch_of(soft) == doctest::Approx(std::pow(1000, 0.4)).epsilon(1e-14));
    CHECK(stiffened(soft).contact.contact_modulus == 90e9);
    const auto expected = expected_impacts(stiff);
    const auto impacts = expected_impacts(soft);
    REQUIRE(impacts.size() == expected.size());
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        CHECK(impacts[i].velocity == expected[i].velocity);
        CHECK(impacts[i].restitution == expected[i].restitution);
        // The softened contact itself has that restitution, with the time and the overlap that are stated.
        const ImpactResult solved = solve_impact(impact_at(soft, impacts[i].diameter, impacts[i].velocity));
        CHECK(relative_difference(solved.restitution, impacts[i].restitution) < 1e-12);
        CHECK(relative_difference(*impacts[i].maximum_overlap, solved.maximum_overlap) < 1e-12);
        CHECK(impacts[i].contact_time.has_value() == solved.contact_time.has_value());
        if (solved.contact_time)
            CHECK(relative_difference(*impacts[i].contact_time, *solved.contact_time) < 1e-12);
    }
    const ExportFolder folder = lammps_folder(soft);
    CHECK(contains(content(folder, "ash_wall.in"), "# Softened: E* is divided by 1000"));
    CHECK(contains(content(folder, "ash_wall.in"), "dmt 180000000 0.000889"));
    CHECK(contains(content(folder, "ash_wall.in"), " 0.00946436"));  // gamma = w/2
    CHECK(contains(content(folder, "README.md"), "damping constant 0.0141 kg/s"));
    CHECK(contains(content(folder, "README.md"), "Softened by 1000"));
    CHECK(contains(content(folder, "assumptions.md"), "lost: forces of contact, adhesion and pull-off"));
    CHECK_FALSE(contains(content(lammps_folder(stiff), "README.md"), "oftened"));
    CHECK_FALSE(contains(content(lammps_folder(stiff), "expected.json"), "softening"));
    CHECK(contains(content(liggghts_folder(soft), "ash_material.in"), "peratomtype 180000000\n"));
    CHECK(contains(content(yade_folder(soft), "impacts.py"), "= 90000000,"));
    const ImpactTable table = make_impact_table(soft);
    for (const ExpectedImpact& each : impacts)
        CHECK(std::abs(restitution(table, each.diameter, each.velocity) - each.restitution) < table_accuracy);
}

TEST_CASE("a softened contact overlaps by at most 5 % of R* in the impacts of a folder") {
    ExportSubject subject = ash("dmt");
    const std::string refused = input_error_of([&] {
        require_small_overlaps(softened(subject, 1000));
        return 0;
    });
    CHECK(contains(refused, "--soften: at 9.044 m/s the contact of 88 um softened 1000 times overlaps by"));
    subject.to_velocity = 2;
    CHECK_NOTHROW(require_small_overlaps(softened(subject, 1000)));
    CHECK_THROWS_AS(require_small_overlaps(softened(subject, 100'000)), InputError);
    // Where adhesion alone pulls the spheres too far together, no velocity is small enough.
    ExportSubject sticky = ash("sjkr");
    sticky.contact.parameters = {{cohesion_energy_density.name, 2e9}};
    sticky.to_velocity = 2;
    sticky.velocity = 1.9;
    const std::string pulled = input_error_of([&] {
        require_small_overlaps(softened(sticky, 3000));
        return 0;
    });
    CHECK(contains(pulled, "--soften "));
    CHECK_FALSE(contains(pulled, "--to-velocity"));
    CHECK_THROWS_AS(static_cast<void>(softened(subject, 1)), InputError);
}

TEST_CASE(
    "LAMMPS gets the damping along its nodes: lines between them, and what it is at either end beyond") {
    ExportSubject subject = ash("dmt");
    subject.damping.nodes = {{1, 0.016}, {2, 0.012}, {4, 0.011}};
    const std::string input = content(lammps_folder(subject), "ash_wall.in");
    const auto at = input.find("ash_curve0 atom \"");
    REQUIRE(at != std::string::npos);
    const std::string curve = input.substr(at, input.find('\n', at) - at);
    // A sum of ramps: the coefficient at the first node, and the change of slope at each.
    const std::regex ramp(
        R"RE(\(([-+.0-9e]+)\)\*\(f_ash_memory>([-+.0-9e]+)\)\*\(f_ash_memory-([-+.0-9e]+)\))RE");
    for (const double velocity : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 9.0}) {
        CAPTURE(velocity);
        double sum = std::stod(curve.substr(curve.find('"') + 1));
        for (std::sregex_iterator match(curve.begin(), curve.end(), ramp), end; match != end; ++match)
            sum += std::stod((*match)[1]) * std::max(0.0, velocity - std::stod((*match)[2]));
        CHECK(relative_difference(sum, subject.damping.coefficient(88e-6, velocity)) < 1e-12);
    }
}

TEST_CASE("the assumptions of LAMMPS name each force that is added to its wall, and no other") {
    const auto names = [](const ExportSubject& subject, const std::string& force) {
        return content(lammps_folder(subject), "assumptions.md").find(force) != std::string::npos;
    };
    ExportSubject tsuji = ash("dmt");
    tsuji.damping = {.law = DampingLaw::tsuji, .nodes = {{0, 0.5}}, .reference_diameter = 88e-6};
    CHECK_FALSE(names(ash("hertz"), "`fix addforce`"));
    CHECK_FALSE(names(ash("dmt"), "`fix addforce`"));
    CHECK(names(ash("brach-dunn"), "attraction 2 pi f sqrt(R* overlap)"));
    CHECK_FALSE(names(ash("brach-dunn"), "damping force -eta v"));
    CHECK_FALSE(names(tsuji, "attraction 2 pi w R*"));
    CHECK(names(tsuji, "damping force -eta v"));
}

}  // namespace ashimpact::test
