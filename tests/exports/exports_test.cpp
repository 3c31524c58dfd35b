// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <regex>
#include <string>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/present/export/folder.hpp"
#include "pipeline/present/export/laboratory.hpp"
#include "pipeline/present/export/subject.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/damping/brach_dunn.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

/// Fly ash of 88 um with constant damping.
ExportSubject ash(std::string_view law_name) {
    const Law law = Law::named(law_name);
    const ContactPair contact{.mass = sphere_mass(44e-6, 2600),
                              .effective_radius = 44e-6,
                              .contact_modulus = 90e9,
                              .work_of_adhesion = 0.3};
    return {.law = law,
            .detachment = law.default_detachment(),
            .sizes = {{.diameter = 88e-6, .contact = contact, .density = 2600, .damping = {{{0, 0.0141}}}}},
            .from_diameter = 88e-6,
            .to_diameter = 88e-6};
}

ExportSubject sizes(ExportSubject subject, double from, double to, double exponent) {
    subject.from_diameter = from;
    subject.to_diameter = to;
    subject.exponent = exponent;
    return subject;
}

/// Another damping law with one coefficient.
ExportSubject damped(ExportSubject subject, DampingLaw law, double coefficient) {
    subject.damping_law = law;
    subject.sizes.front().damping = {{{0, coefficient}}};
    return subject;
}

/// Ash whose damping falls above v_c, as measured impacts show it.
ExportSubject followed(std::string_view law) {
    ExportSubject subject = ash(law);
    subject.sizes.front().damping = {{{0, 0.0141}, {0.3, 0.0125}, {0.8, 0.0098}, {1.4, 0.0071}}};
    return subject;
}

/// Three sizes, each with its own E*, density and damping along the velocity.
ExportSubject three_sizes(std::string_view law) {
    ExportSubject subject = followed(law);
    const auto add = [&](double diameter, double modulus, double density, DampingCurve damping) {
        ContactPair contact = subject.reference().contact;
        contact.effective_radius = diameter / 2;
        contact.mass = sphere_mass(diameter / 2, density);
        contact.contact_modulus = modulus;
        subject.sizes.push_back({diameter, contact, density, std::move(damping)});
    };
    add(96e-6, 91e9, 2550, {{{0, 0.0165}, {0.5, 0.013}, {1.6, 0.009}}});
    add(120e-6, 95e9, 2400, {{{0, 0.021}, {0.2, 0.0195}, {1.2, 0.013}, {2.0, 0.0135}}});
    subject.to_diameter = 120e-6;
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
    subject.sizes.front().contact.effective_radius /= 2;
    subject.sizes.front().contact.mass /= 2;
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
    const ExportSubject subject = damped(ash("hertz"), DampingLaw::contact_radius, 300);
    const ImpactTable table = make_impact_table(subject);
    CHECK_FALSE(table.captures);
    CHECK(table.from_velocity == doctest::Approx(table.to_velocity / 1000));
    CHECK(worst_error(subject, table) < table_accuracy);
}

TEST_CASE("a table follows the damping along the velocity, at several sizes with their own contacts" *
          doctest::test_suite("long")) {
    for (const char* law : {"hertz", "dmt", "jkr"}) {
        CAPTURE(law);
        for (ExportSubject subject : {followed(law), sizes(followed(law), 30e-6, 200e-6, 1.5),
                                      three_sizes(law), sizes(three_sizes(law), 60e-6, 150e-6, 2)}) {
            CAPTURE(subject.sizes.size());
            const ImpactTable table = make_impact_table(subject);
            CHECK(table.largest_error < table_accuracy);
            CHECK(worst_error(subject, table) < table_accuracy);
            // Several known sizes are sizes of the table; one within a range lies between those.
            const bool is_size = subject.one_size() || subject.sizes.size() > 1;
            for (const AshSize& size : subject.sizes)
                CHECK(relative_difference(start_velocity(table, size.diameter),
                                          *threshold_at(subject, size.diameter).value) <
                      (is_size ? 1e-14 : table_threshold_accuracy));
            CHECK(std::ranges::is_sorted(table.diameter, std::ranges::less_equal()));
        }
    }
}

TEST_CASE("damping that rises so steeply that faster spheres are captured again is refused") {
    ExportSubject subject = ash("hertz");
    subject.sizes.front().damping = {{{0, 0.0141}, {0.5, 0.0141}, {0.8, 0.024}}};
    CHECK(contains(input_error_of([&] { return make_impact_table(subject); }), "more than once"));
}

TEST_CASE("ash between two known sizes has what lies between theirs, and at a known size its own") {
    const ExportSubject subject = three_sizes("dmt");
    const AshBetween at = ash_at(subject, 96e-6);
    CHECK(at.damping(0) == 0.0165);
    CHECK(at.damping(0.25) == doctest::Approx(0.015625).epsilon(1e-14));
    CHECK(at.damping(9) == 0.009);
    CHECK(contact_at(subject, 96e-6).contact_modulus == 91e9);
    CHECK(contact_at(subject, 96e-6).mass == subject.sizes[1].contact.mass);
    const double d = std::sqrt(88e-6 * 96e-6);  // the middle in ln d
    CHECK(relative_difference(ash_at(subject, d).damping(0), std::sqrt(0.0141 * 0.0165)) < 1e-14);
    CHECK(relative_difference(ash_at(subject, d).damping(5), std::sqrt(0.0071 * 0.009)) < 1e-14);
    CHECK(relative_difference(contact_at(subject, d).contact_modulus, 90.5e9) < 1e-14);
    CHECK(relative_difference(ash_at(subject, d).density(), 2575) < 1e-14);
    // Beyond the known sizes: those of the nearest one, with the damping by the exponent.
    const ExportSubject wide = sizes(subject, 44e-6, 240e-6, 2);
    CHECK(relative_difference(ash_at(wide, 44e-6).damping(0.3), 0.0125 / 4) < 1e-14);
    CHECK(relative_difference(ash_at(wide, 240e-6).damping(0), 0.084) < 1e-14);
    CHECK(contact_at(wide, 240e-6).contact_modulus == 95e9);
}

TEST_CASE("one damping at every velocity is that of each size at the velocity") {
    const ExportSubject subject = three_sizes("dmt");
    const ExportSubject constant = with_damping_at(subject, 3);
    for (const AshSize& size : subject.sizes) {
        CHECK(impact_at(constant, size.diameter, 0.1).damping.coefficient ==
              impact_at(subject, size.diameter, 3).damping.coefficient);
        CHECK(impact_at(constant, size.diameter, 3).damping.coefficient < size.damping.critical());
    }
}

TEST_CASE("a table of a law with a parameter of its own has that parameter in its impacts") {
    ExportSubject subject = ash("sjkr");
    subject.sizes.front().contact.parameters = {{cohesion_energy_density.name, 2e9}};
    const ImpactTable table = make_impact_table(subject);
    CHECK(worst_error(subject, table) < table_accuracy);
    const double strong = table.start_velocity.front();
    subject.sizes.front().contact.parameters = {{cohesion_energy_density.name, 0.0}};
    CHECK(strong > 1.1 * make_impact_table(subject).start_velocity.front());
}

TEST_CASE("what a table cannot hold is refused") {
    const ExportSubject captured = damped(ash("hertz"), DampingLaw::tsuji, 3);
    CHECK_THROWS_AS(static_cast<void>(make_impact_table(captured)), InputError);
    ExportSubject slow = ash("dmt");
    slow.to_velocity = 1e-3;
    CHECK_THROWS_AS(static_cast<void>(make_impact_table(slow)), InputError);
    CHECK_THROWS_AS(static_cast<void>(make_impact_table(sizes(ash("dmt"), 1e-9, 1, 0))), InputError);
}

TEST_CASE("damping goes along its nodes, and its place above v_c has an inverse") {
    const DampingCurve damping{{{0, 4.0}, {1, 2.0}, {3, 1.0}}};
    CHECK(damping(0) == 4.0);
    CHECK(damping(0.5) == 3.5);
    CHECK(damping(2) == 1.625);
    CHECK(damping(9) == 1.0);
    CHECK(damping.depends_on_velocity());
    CHECK(place_above(0.5, 1) == 0);
    CHECK(velocity_at_place(0, 1.7) == 1.7);
    for (const double v : {1.0001, 1.3, 4.0, 50.0})
        CHECK(relative_difference(velocity_at_place(place_above(v, 1), 1), v) < 1e-13);
}

TEST_CASE("damping that goes with the square of the size keeps the critical velocity of Hertz spheres") {
    ExportSubject subject = ash("hertz");
    subject.exponent = 2;
    CHECK(relative_difference(*threshold_at(subject, 20e-6).value, *threshold_at(subject, 88e-6).value) <
          1e-12);
}

TEST_CASE("expected impacts lie on both sides of the critical velocity") {
    ExportSubject subject = ash("dmt");
    subject.from_diameter = 60e-6;
    subject.exponent = 2;
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
    two.exponent = 2;
    refused(lammps_folder, two, "--damping-exponent 0");
    CHECK_FALSE(yade_folder(damped(ash("dmt"), DampingLaw::tsuji, 0.5)).empty());
    two = two_spheres("dmt");
    two.sizes.front().damping = {{{0, 0.0035}, {1, 0.002}}};
    refused(lammps_folder, two, "velocity of approach");
    refused(liggghts_folder, two, "velocity of approach");
    CHECK_FALSE(yade_folder(two).empty());
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

TEST_CASE("zeta_A is that of every size, or goes with zeta_H, in decks as in the expected impacts") {
    ExportSubject subject = damped(sizes(ash("dmt"), 44e-6, 88e-6, 1), DampingLaw::brach_dunn, 0.2);
    ContactPair& contact = subject.sizes.front().contact;
    contact.parameters.set("adhesion_damping", 0.5);
    CHECK(impact_at(subject, 44e-6, 1).contact.parameters[adhesion_damping] == 0.5);
    const std::string scaled = "0.20000000000000001*(2*c_ash_radius/8.7999999999999998e-05)^(1)*";
    const std::string deck = content(lammps_folder(subject), "ash_wall.in");
    CHECK(contains(deck, scaled + "120000000000*sqrt(c_ash_radius*v_ash_depth)*v_ash_depth + 0.5*"));
    CHECK(contains(content(yade_folder(subject), "impacts.py"), "ADHESION_DAMPING = 0.5 "));
    CHECK(contains(content(lammps_folder(subject), "assumptions.md"), "zeta_A 0.5 s/m at every size"));
    contact.parameters = {};
    contact.parameters.set("adhesion_damping_ratio", 2.5);
    CHECK(contains(content(lammps_folder(subject), "ash_wall.in"), scaled + "(120000000000*"));
}

TEST_CASE("a softened folder has the impacts of the stiff contact, and constants that follow E*") {
    ExportSubject stiff = ash("dmt");
    stiff.to_velocity = 2;
    const ExportSubject soft = softened(stiff, 1000);
    CHECK(stretch_of(soft) == doctest::Approx(std::pow(1000, 0.4)).epsilon(1e-14));
    CHECK(stiffened(soft).reference().contact.contact_modulus == 90e9);
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
    sticky.sizes.front().contact.parameters = {{cohesion_energy_density.name, 2e9}};
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

TEST_CASE("LAMMPS gets the damping along its nodes, as a sum of ramps, and v_c by size as a polynomial") {
    const ExportSubject subject = sizes(followed("dmt"), 30e-6, 120e-6, 1.5);
    const std::string input = content(lammps_folder(subject), "ash_wall.in");
    const auto formula = [&](const std::string& name) {
        const auto at = input.find("ash_" + name + " atom \"");
        REQUIRE(at != std::string::npos);
        const auto from = input.find('"', at) + 1;
        return input.substr(from, input.find('"', from) - from);
    };
    // The coefficient at the first node, and the change of slope at each.
    const std::string curve = formula("curve0");
    const std::regex ramp(
        R"RE(\(([-+.0-9e]+)\)\*\(f_ash_place>([-+.0-9e]+)\)\*\(f_ash_place-([-+.0-9e]+)\))RE");
    for (const double t : {0.0, 0.2, 0.3, 0.5, 1.0, 1.4, 3.0}) {
        CAPTURE(t);
        double sum = std::stod(curve);
        for (std::sregex_iterator match(curve.begin(), curve.end(), ramp), end; match != end; ++match)
            sum += std::stod((*match)[1]) * std::max(0.0, t * t - std::stod((*match)[2]));
        CHECK(relative_difference(sum, subject.reference().damping(t)) < 1e-12);
    }
    // exp((c0 + v_ash_size*(c1 + v_ash_size*...)))
    const std::string critical = formula("critical");
    std::vector<double> powers;
    for (const char* at = critical.c_str(); *at != '\0';) {
        char* end = nullptr;
        const double number = std::strtod(at, &end);
        if (end == at || *at == '+' || *at == 'e') {
            ++at;
            continue;
        }
        powers.push_back(number);
        at = end;
    }
    REQUIRE(powers.size() > 6);
    for (const double d : {30e-6, 41e-6, 88e-6, 111e-6, 120e-6}) {
        CAPTURE(d);
        const double x = (std::log(d) - 0.5 * (std::log(30e-6) + std::log(120e-6))) / (0.5 * std::log(4.0));
        double sum = 0;
        for (auto power = powers.rbegin(); power != powers.rend(); ++power) sum = sum * x + *power;
        CHECK(relative_difference(std::exp(sum), *threshold_at(subject, d).value) < 1e-9);
    }
}

TEST_CASE("expected impacts stand beside what the laboratory measured there") {
    ExportSubject subject = three_sizes("dmt");
    const double critical = *threshold_at(subject, 96e-6).value;
    const ExportSubject truth = subject;
    Laboratory laboratory{.sample = "made up", .diameter = 96e-6, .impacts = {{0.5 * critical, 0}}};
    for (double v = 1.05 * critical; v < 6 * critical; v *= 1.02)
        laboratory.impacts.push_back({v, solve_impact(impact_at(truth, 96e-6, v)).restitution});
    subject.laboratory = {laboratory};
    CHECK(laboratory_differences(subject).front().largest < 1e-9);
    CHECK(laboratory_differences(subject).front().other_outcomes == 0);
    // With the critical damping at every velocity, as exports had it, e is far too small.
    const auto off = laboratory_differences(with_damping_at(subject, critical));
    CHECK(off.front().largest > 0.2);
    CHECK(off.front().at_velocity > 3 * critical);
    CHECK(*measured_restitution(subject, 96e-6, 2 * critical) ==
          doctest::Approx(solve_impact(impact_at(truth, 96e-6, 2 * critical)).restitution).epsilon(0.02));
    CHECK(measured_restitution(subject, 96e-6, 0.5 * critical) == 0.0);
    CHECK_FALSE(measured_restitution(subject, 96e-6, 20 * critical).has_value());
    CHECK_FALSE(measured_restitution(subject, 88e-6, 2 * critical).has_value());
    const std::string line = "e against the measured impacts of 96 um";
    CHECK(contains(content(openfoam_folder(subject), "README.md"), line));
    CHECK(contains(content(fluent_folder(subject), "README.md"), line));
    CHECK_FALSE(contains(content(lammps_folder(followed("dmt")), "README.md"), "e against"));
    const Json expected = Json::parse(content(openfoam_folder(subject), "expected.json"));
    CHECK(expected["laboratory"]["samples"].size() == 1);
    int beside = 0;
    for (const Json& impact : expected["impacts"]) beside += impact["measured_restitution"].is_null() ? 0 : 1;
    CHECK(beside == 3);  // 1.2, 2 and 5 v_c of 96 um
}

TEST_CASE("a critical velocity outside the model is not exported") {
    ExportSubject subject = sizes(ash("jkr"), 0.5e-6, 88e-6, 0);
    CHECK(contains(input_error_of([&] {
                       require_inside_model(subject);
                       return 0;
                   }),
                   "outside the model"));
    CHECK_NOTHROW(require_inside_model(ash("jkr")));
}

TEST_CASE("the assumptions of LAMMPS name each force that is added to its wall, and no other") {
    const auto names = [](const ExportSubject& subject, const std::string& force) {
        return content(lammps_folder(subject), "assumptions.md").find(force) != std::string::npos;
    };
    const ExportSubject tsuji = damped(ash("dmt"), DampingLaw::tsuji, 0.5);
    CHECK_FALSE(names(ash("hertz"), "`fix addforce`"));
    CHECK_FALSE(names(ash("dmt"), "`fix addforce`"));
    CHECK(names(ash("brach-dunn"), "attraction 2 pi f sqrt(R* overlap)"));
    CHECK_FALSE(names(ash("brach-dunn"), "damping force -eta v"));
    CHECK_FALSE(names(tsuji, "attraction 2 pi w R*"));
    CHECK(names(tsuji, "damping force -eta v"));
}

}  // namespace ashimpact::test
