// SPDX-License-Identifier: GPL-3.0-or-later
// Law maugis-dugdale, a second sphere and rough surfaces, as typed.
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/json/document.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/files/file.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// What a command prints with --json.
Json printed(const Sandbox& sandbox, const std::string& arguments) {
    const auto result = ashimpact_program(sandbox, arguments + " --json");
    CAPTURE(arguments);
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return Json::parse(result.out);
}

double number(const Json& quantity) {
    return quantity["value"].get<double>();
}

const std::string rest = " --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2' --damping '0.001 kg/s'";

/// The built-in modulus of the example on a partner in place of the wall.
Json with_partner(const Json& partner) {
    Json document = example_case();
    document["laws"] = {"jkr"};
    document.erase("wall");
    document["partner"] = partner;
    for (Json& sample : document["samples"]) sample.erase("restitution");
    return document;
}

const Json steel_ball = Json::parse(R"({"diameter": {"value": 200, "unit": "um", "standard_uncertainty": 4},
    "density": "7800 kg/m3", "young_modulus": "193 GPa", "poisson_ratio": 0.29})");

}  // namespace

TEST_CASE("every stated uncertainty is in the properties of the contact and of the modulus") {
    const Sandbox sandbox;
    Json document = with_partner(steel_ball);
    document["partner"]["density"] = "7800 +- 390 kg/m3";  // 5 %
    document["partner"]["young_modulus"] = "193 +- 20 GPa";
    document["samples"][0].erase("density");
    document["samples"][0]["porosity"] = {{"law", "pabst-gregorova"}, {"value", "15 +- 5 %"}};
    write_example(sandbox, document);
    const auto finished = ashimpact_program(sandbox, "run case.json -o out --no-report");
    CAPTURE(finished.err);
    REQUIRE(finished.status == 0);
    const auto sample_of = [&](const char* file) {
        return sandbox.json(std::string("out/") + file)["result"]["samples"][0];
    };
    const Json contact = sample_of("2-contact.json");
    const auto u = [](const Json& quantity) { return quantity["standard_uncertainty"].get<double>(); };
    const Json& mass = contact["partner"]["mass"];
    CHECK(relative_difference(u(mass) / number(mass), std::hypot(3 * 0.02, 0.05)) < 1e-9);
    const Json modulus = sample_of("1-modulus.json");
    const Json& dense = modulus["density"];
    const double of_phases = dense.value("standard_uncertainty", 0.0);
    CHECK(relative_difference(u(contact["density"]), std::hypot(0.85 * of_phases, 0.05 * number(dense))) <
          1e-9);
    // Eq. 7, each body's compliance moved by its modulus.
    const double particle = number(modulus["young_modulus"]);
    const double nu = number(contact["poisson_ratio"]);
    const ElasticBody ball{.young_modulus = 193e9, .poisson_ratio = 0.29};
    const double e = contact_modulus({particle, nu}, ball);
    const double by_particle = contact_modulus({particle * (1 + 1e-6), nu}, ball) - e;
    const double by_ball = contact_modulus({particle, nu}, {193e9 * (1 + 1e-6), 0.29}) - e;
    const double expected =
        std::hypot(by_particle / 1e-6 * u(modulus["young_modulus"]) / particle, by_ball / 1e-6 * 20 / 193);
    CHECK(u(contact["contact_modulus"]) > 0.99 * expected);  // and Poisson's ratio
    // ln E goes with -2/(1 - P)^2.
    for (const char* end : {"lower", "upper"}) {
        const Json& bound = modulus["bounds"][end];
        CHECK(u(bound) / number(bound) > 0.99 * 2 / (0.85 * 0.85) * 0.05);
    }
}

TEST_CASE("maugis-dugdale takes exactly one of Tabor parameter, cohesive stress and range") {
    const Sandbox sandbox;
    const std::string impact =
        "impact --law maugis-dugdale --radius '44 um' --density 2600 --velocity 2" + rest;
    const Json json = printed(sandbox, impact + " --tabor 2");
    CHECK(json["detachment"] == "pull-off");
    CHECK(json["outcome"] == "rebound");
    CHECK(number(json["energy"]["jumps"]) > 0.0);
    CHECK(number(json["regime"]["greatest_pressure"]) > 1e8);
    CHECK(std::abs(json["regime"]["transition_parameter"].get<double>() - 2.3140) < 1e-4);
    for (const std::string given : {" --cohesive-stress '770 MPa'", " --cohesion-range '0.4 nm'"})
        CHECK(printed(sandbox, impact + given)["outcome"] == "rebound");
    for (const std::string given : {"", " --tabor 2 --cohesion-range '0.4 nm'"}) {
        const auto refused = ashimpact_program(sandbox, impact + given);
        CHECK(refused.status == 2);
        CHECK(refused.err == containing("--tabor"));
        CHECK(refused.err == containing("--cohesion-range"));
    }
    check_refused(sandbox, impact + " --tabor 0.5 --detachment load-controlled", "would gain energy");
    CHECK(ashimpact_program(sandbox, impact + " --tabor 1e9").status == 2);
}

TEST_CASE("two spheres: m* and R* of both, the wall as the limit of a large partner") {
    const Sandbox sandbox;
    for (const std::string law : {"dmt", "jkr"}) {
        const std::string command = fmt::format("critical-velocity --law {}{}", law, rest);
        const auto velocity = [&](const std::string& bodies) {
            return number(printed(sandbox, command + bodies)["critical_velocity"]);
        };
        // Two equal spheres are one of half the mass and half the radius on a wall.
        const double pair =
            velocity(" --radius '40 um' --mass '2e-10 kg' --partner-radius '40 um' --partner-mass 2e-10");
        const double halved = velocity(" --radius '20 um' --mass '1e-10 kg'");
        CHECK(relative_difference(pair, halved) < 1e-12);
        const double wall = velocity(" --radius '40 um' --density 2600");
        double before = 1.0;
        for (const std::string radius : {"4 mm", "40 mm", "400 mm"}) {
            const double near = velocity(
                " --radius '40 um' --density 2600 --partner-density 2600 --partner-radius '" + radius + "'");
            const double distance = relative_difference(near, wall);
            CHECK(distance < 0.2 * before);
            before = distance;
        }
    }
    const auto lonely = ashimpact_program(
        sandbox, "critical-velocity --law dmt --radius '40 um' --density 2600 --partner-density 2600" + rest);
    CHECK(lonely.status == 2);
    CHECK(lonely.err == containing("--partner-radius"));

    // The second sphere by its diameter, wherever it may be given by its radius.
    for (const std::string command : {"critical-velocity --law dmt --damping 0.001", "contact",
                                      "impact --law jkr --velocity 1 --damping 0"}) {
        CAPTURE(command);
        const std::string spheres = command +
                                    " --json --diameter '80 um' --density 2600 --partner-density 2600 "
                                    "--contact-modulus '90 GPa' --work-of-adhesion 0.3";
        const auto by_radius = ashimpact_program(sandbox, spheres + " --partner-radius '30 um'");
        const auto by_diameter = ashimpact_program(sandbox, spheres + " --partner-diameter '60 um'");
        CHECK_MESSAGE(by_diameter.status == 0, by_diameter.err);
        CHECK(by_diameter.out == by_radius.out);
        const auto both =
            ashimpact_program(sandbox, spheres + " --partner-radius '30 um' --partner-diameter '60 um'");
        CHECK(both.status == 2);
        CHECK(both.err == containing("--partner-diameter, --partner-radius: both are given"));
    }
}

TEST_CASE("rough surfaces: less adhesion, never by default") {
    const Sandbox sandbox;
    const std::string command = "critical-velocity --law jkr --radius '44 um' --density 2600" + rest;
    const double smooth = number(printed(sandbox, command)["critical_velocity"]);
    CHECK(number(printed(sandbox, command + " --roughness 0")["critical_velocity"]) == smooth);
    CHECK(number(printed(sandbox, command + " --roughness '1 nm'")["critical_velocity"]) < smooth);
    CHECK(ashimpact_program(sandbox, command + " --roughness '-1 nm'").status == 2);
}

TEST_CASE(
    "a case with rough surfaces: w is reduced as the command does, off by default, with its uncertainty") {
    const Sandbox sandbox;
    Json document = example_case();
    document["laws"] = {"jkr"};
    for (Json& sample : document["samples"]) sample.erase("restitution");
    const auto contact_of = [&](const Json& roughness) {
        Json changed = document;
        if (!roughness.is_null()) changed["roughness"] = roughness;
        write_example(sandbox, changed);
        succeeded(sandbox, "run case.json -o rough -q --no-report");
        return sandbox.json("rough/2-contact.json")["result"]["samples"][0];
    };
    const auto energy = [&] {
        return number(sandbox.json("rough/3-analytic.json")["result"]["samples"][0]["separation_energy"]);
    };
    const Json smooth = contact_of(nullptr);
    const double smooth_energy = energy();
    CHECK_FALSE(smooth.contains("roughness"));
    CHECK_FALSE(smooth.contains("smooth_work_of_adhesion"));
    CHECK(contact_of(0) == smooth);
    const double w = number(smooth["work_of_adhesion"]);
    const double radius = number(smooth["effective_radius"]);
    const Json rough =
        contact_of({{"value", 2}, {"unit", "nm"}, {"standard_uncertainty", 0.1}, {"origin", "measured"}});
    CHECK(number(rough["smooth_work_of_adhesion"]) == w);
    CHECK(number(rough["roughness"]) == doctest::Approx(2e-9).epsilon(1e-15));
    const double asperity = 1.48 * 2e-9;
    const double left = 1 / (1 + radius / asperity) + std::pow(1 + asperity / 0.3e-9, -2);
    CHECK(relative_difference(number(rough["work_of_adhesion"]), w * left) < 1e-12);
    CHECK(rough["work_of_adhesion"]["standard_uncertainty"].get<double>() > 0);
    // The run goes on with the w that is left: W_s goes with w^(5/3).
    CHECK(relative_difference(energy() / smooth_energy, std::pow(left, 5.0 / 3.0)) < 1e-12);
    Json coarse = document;
    coarse["roughness"] = "50 nm";
    write_example(sandbox, coarse);
    const auto warned = ashimpact_program(sandbox, "run case.json -o rough --no-report");
    CHECK(warned.status == 0);
    CHECK(sandbox.json("rough/2-contact.json")["warnings"].dump() == containing("meant for an rms"));
    for (const char* wrong : {"-1 nm", "1 kg"}) {
        Json changed = document;
        changed["roughness"] = wrong;
        write_example(sandbox, changed);
        const auto refused = ashimpact_program(sandbox, "run case.json -o rough --no-report");
        CHECK(refused.status == 2);
        CHECK(refused.err.find("case.json: /roughness") == 0);
    }
}

TEST_CASE("a case with a second sphere: its contact, and that of equal spheres") {
    const Sandbox sandbox;
    const auto contact_of = [&](const Json& document) {
        write_example(sandbox, document);
        succeeded(sandbox, "run case.json -o two --no-report");
        return sandbox.json("two/2-contact.json")["result"]["samples"][0];
    };
    const Json two = contact_of(with_partner(steel_ball));
    const double radius = number(two["radius"]);
    const double mass = number(two["mass"]);
    CHECK(radius == 44e-6);
    CHECK(relative_difference(number(two["effective_radius"]), 1 / (1 / radius + 1 / 100e-6)) < 1e-14);
    const double ball = 4.0 / 3.0 * 3.14159265358979 * 1e-12 * 7800;
    CHECK(relative_difference(number(two["partner"]["mass"]), ball) < 1e-13);
    CHECK(relative_difference(number(two["effective_mass"]), 1 / (1 / mass + 1 / ball)) < 1e-13);
    // d R*/d r = (R*/r)^2, and half of 4 um is the partner's alone.
    const double share = std::pow(number(two["effective_radius"]) / 100e-6, 2);
    CHECK(relative_difference(two["effective_radius"]["standard_uncertainty"].get<double>(), share * 2e-6) <
          1e-12);
    const Json analytic = sandbox.json("two/3-analytic.json")["result"]["samples"][0];
    CHECK(relative_difference(
              number(analytic["critical_velocity"]),
              std::sqrt(2 * number(analytic["separation_energy"]) / number(two["effective_mass"]))) < 1e-13);
    CHECK(number(sandbox.json("two/comparison.json")["result"]["samples"][0]["diameter"]) == 88e-6);

    Json equal = steel_ball;
    equal["diameter"] = "88 um";
    equal.erase("density");
    equal["mass"] = mass;
    const Json halves = contact_of(with_partner(equal));
    CHECK(relative_difference(number(halves["effective_radius"]), radius / 2) < 1e-15);
    CHECK(relative_difference(number(halves["effective_mass"]), mass / 2) < 1e-15);
}

TEST_CASE("a case with a second sphere: measured impacts, edits of the spheres, what is refused") {
    const Sandbox sandbox;
    Json document = with_partner(steel_ball);
    document["samples"][0]["restitution"] = example_case()["samples"][0]["restitution"];
    document["samples"].erase(1);
    write_example(sandbox, document);
    const auto run = succeeded(sandbox, "run case.json -o two");
    const Json contact = sandbox.json("two/2-contact.json")["result"]["samples"][0];
    const Json velocity = sandbox.json("two/7-critical-velocity.json")["result"]["samples"][0]["jkr"];
    const auto digits = [](const Json& quantity) {
        return " " + std::to_string(number(quantity) * 1e12) + "e-12";
    };
    const Json direct = printed(
        sandbox, "critical-velocity --law jkr --radius 44e-6 --partner-radius 100e-6 --mass" +
                     digits(contact["mass"]) + " --partner-mass" + digits(contact["partner"]["mass"]) +
                     " --contact-modulus" + digits(contact["contact_modulus"]) +
                     " --work-of-adhesion 0.3 --damping" + digits(velocity["damping"]));
    CHECK(relative_difference(number(direct["critical_velocity"]), number(velocity["critical_velocity"])) <
          1e-6);
    CHECK(sandbox.read("two/report.html") == containing("normal impact on another sphere"));

    Json artifact = sandbox.json("two/2-contact.json");
    artifact["result"]["samples"][0]["partner"]["radius"]["value"] = 50e-6;
    sandbox.write("two/2-contact.json", artifact.dump());
    check_refused(sandbox, "run -o two --from analytic", "/effective_radius: is not that of the two spheres");

    for (const auto& [edits, message] : {
             std::pair{R"(/wall = {"rigid": true})", "/partner: a wall and a second sphere are both given"},
             {"- /partner/density", "/partner: the density and the mass are both given, or neither"},
             {"- /partner/young_modulus", "/partner: \"young_modulus\" is missing"},
             {"- /partner/young_modulus ; - /partner/poisson_ratio",
              "neither the partner's elasticity nor a contact modulus is given"},
             {R"(/partner/diameter = "-1 um")", "/partner/diameter"},
             {R"(/work_of_adhesion = {"rule": "girifalco-good", "surface_energies": )"
              R"({"particle": 0.04, "wall": 0.5, "partner": 0.5}})",
              "the surface energy of the other body is given twice"},
         }) {
        write_example(sandbox, edited(document, edits));
        check_refused(sandbox, "run case.json -o none", message);
    }
    const auto exported = ashimpact_program(sandbox, "export table two --sample fine --law jkr -o folder");
    CHECK(exported.status == 2);
    CHECK_FALSE(sandbox.has("folder"));
}

TEST_CASE("a sweep over the partner's radius is so many impacts of two spheres") {
    const Sandbox sandbox;
    Json spec = Json::parse(R"({
        "impact": {"laws": ["jkr"], "radius": "44 um", "density": 2600, "contact_modulus": "90 GPa",
                   "work_of_adhesion": 0.3, "damping": 0.001, "velocity": 2, "partner_density": 7800},
        "variables": {"partner_radius": {"values": [2e-5]}}, "sampling": {"method": "grid"},
        "statistics": {"restitution": {}}})");
    const auto mean_of = [&] {
        sandbox.write("spec.json", spec.dump());
        const auto run = succeeded(sandbox, "sweep spec.json -o out.json");
        CHECK(run.err != containing("no report"));
        return number(sandbox.json("out.json")["result"]["laws"][0]["observables"][0]["mean"]);
    };
    const std::string alone = "impact --law jkr --radius 44e-6 --density 2600 --velocity 2 --partner-radius ";
    for (const std::string radius : {"2e-5", "0.0001"}) {
        spec["variables"]["partner_radius"]["values"] = {std::stod(radius)};
        const Json impact =
            printed(sandbox, fmt::format("{}{} --partner-density 7800{}", alone, radius, rest));
        CHECK(relative_difference(mean_of(), number(impact["restitution"])) < 1e-9);
    }
    spec["impact"].erase("partner_density");
    spec["impact"]["partner_mass"] = 1e-9;
    const Json impact = printed(sandbox, alone + "0.0001 --partner-mass 1e-9" + rest);
    CHECK(relative_difference(mean_of(), number(impact["restitution"])) < 1e-9);

    const auto refused = [&](const char* message) {
        sandbox.write("spec.json", spec.dump());
        const auto run = ashimpact_program(sandbox, "sweep spec.json -o none.json");
        CHECK(run.status == 2);
        CHECK(run.err == containing(message));
    };
    spec["impact"]["partner_density"] = 7800;
    refused("both \"partner_density\" and \"partner_mass\" are given");
    spec["impact"].erase("partner_density");
    spec["impact"].erase("partner_mass");
    refused("\"partner_density\" is missing, and so is \"partner_mass\"");
    spec["impact"]["partner_mass"] = 1e-9;
    spec["variables"] = Json::parse(R"({"velocity": {"values": [1]}})");
    spec["impact"].erase("velocity");
    refused("\"partner_radius\" is missing");
}

TEST_CASE("the report of a sweep takes the parameters of its law") {
    const Sandbox sandbox;
    sandbox.write("spec.json", R"({
        "impact": {"laws": ["sjkr"], "radius": "44 um", "density": 2600, "contact_modulus": "90 GPa",
                   "cohesion_energy_density": "100 MJ/m3", "damping": 0.001},
        "variables": {"velocity": {"values": [0.01, 0.02, 2]}}, "sampling": {"method": "grid"}})");
    const auto run = succeeded(sandbox, "sweep spec.json -o out.json");
    CHECK(run.err != containing("no report"));
    CHECK(sandbox.has("out.html"));
}

TEST_CASE("docs/small-particles.md: every critical velocity in its tables is the solver's") {
    const std::string page =
        read_file(std::filesystem::path(ASHIMPACT_TEST_DATA) / "../../docs/small-particles.md");
    const std::array laws{Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>(),
                          Law::of<MaugisDugdale>()};
    double damping = 0;
    int finite = 0;
    int never = 0;
    for (const std::string& line : lines_of(page)) {
        if (line.starts_with("**C = ")) damping = std::stod(line.substr(6));
        std::istringstream cells(line);
        std::string cell;
        std::vector<std::string> row;
        while (std::getline(cells, cell, '|')) row.push_back(cell);
        if (row.size() != 8 || row[1].find_first_of("0123456789") != 1) continue;
        const double radius = 0.5e-6 * std::stod(row[1]);
        const ContactPair pair{.mass = sphere_mass(radius, 2200),
                               .effective_radius = radius,
                               .contact_modulus = 90e9,
                               .work_of_adhesion = 0.3,
                               .parameters = {{"cohesion_range", 0.4e-9}}};
        for (std::size_t i = 0; i < laws.size(); ++i) {
            CAPTURE(line);
            CAPTURE(laws[i].name());
            const CriticalVelocity found = critical_velocity(
                {laws[i], laws[i].default_detachment(), {DampingLaw::tsuji, damping}, pair});
            if (row[i + 3] == " never ") {
                CHECK(found.verdict == CaptureVerdict::never_captured);
                ++never;
                continue;
            }
            REQUIRE(found.value);
            CHECK(std::abs(std::stod(row[i + 3]) / *found.value - 1) < 5.1e-3);
            ++finite;
        }
    }
    CHECK(finite == 70);
    CHECK(never == 35);
}

TEST_CASE("contact lists the JKR contact at rest under a force or of a radius, with its pressure") {
    const Sandbox sandbox;
    const std::string pair =
        "contact --radius '44 um' --density 2600 --contact-modulus '90 GPa' --work-of-adhesion ";
    const Json under_force = printed(sandbox, pair + "'0.3 J/m2' --force '-60 uN' --pressure p.csv");
    const Json& both = under_force["static"];
    REQUIRE(both.size() == 2);
    for (const Json& contact : both) {
        CHECK(number(contact["force"]) == doctest::Approx(-60e-6).epsilon(1e-11));
        const Json again = printed(sandbox, fmt::format("{}'0.3 J/m2' --contact-radius {:.17g}", pair,
                                                        number(contact["contact_radius"])));
        CHECK(again["static"][0] == contact);
        CHECK(number(contact["neutral_radius"]) ==
              doctest::Approx(number(contact["contact_radius"]) *
                              std::sqrt(std::max(0.0, 1 - number(contact["tension_ratio"])))));
    }
    std::istringstream csv(read_file(sandbox.folder() / "p.csv"));
    std::string line;
    std::getline(csv, line);
    CHECK(line == "radius [m],pressure [Pa]");
    std::getline(csv, line);
    CHECK(std::stod(line.substr(2)) ==
          doctest::Approx(number(both[0]["hertz_pressure"]) - number(both[0]["rim_tension"])));
    CHECK(printed(sandbox, pair + "0 --force '1 mN'")["static"][0]["attractive_force"]["value"] == 0);
    for (const auto& [options, message] :
         {std::pair{"--force '-1 mN'", "tears the contact off"},
          std::pair{"--contact-radius '1 nm'", "below the fold"},
          std::pair{"--contact-radius '1 um' --force 0", "both are given"},
          std::pair{"--contact-radius '1 mm'", "the contact has a radius of 1 mm, which is more"},
          std::pair{"--force '1 kN'", "which is more than that of the sphere"},
          std::pair{"--pressure p.csv", "belongs to a contact at rest"}}) {
        const auto result = ashimpact_program(sandbox, pair + "'0.3 J/m2' " + options);
        CHECK(result.status == 2);
        CHECK(result.err == containing(message));
    }
}

TEST_CASE("critical-velocity and damping by the paper's scheme stand beside the exact ones") {
    const Sandbox sandbox;
    const std::string ash = " --law brach-dunn --radius '44 um' --density 2600" + rest;
    const std::string scheme = " --method paper-explicit --time-step '0.2 ns'";
    const Json exact = printed(sandbox, "critical-velocity" + ash);
    const Json both = printed(sandbox, "critical-velocity" + ash + scheme);
    CHECK(both["critical_velocity"] == exact["critical_velocity"]);
    const double velocity = number(both["paper_explicit"]["critical_velocity"]);
    const double difference = velocity / number(exact["critical_velocity"]) - 1;
    CHECK(std::abs(difference) > 1e-6);
    CHECK(std::abs(difference) < 0.05);
    const Json damping = printed(sandbox,
                                 "damping --law brach-dunn --radius '44 um' --density 2600 --contact-modulus "
                                 "'90 GPa' --work-of-adhesion '0.3 J/m2' --velocity 2 --restitution 0.3" +
                                     scheme);
    CHECK(std::abs(number(damping["paper_explicit"]["damping"]) / number(damping["damping"]) - 1) < 0.01);
    CHECK(ashimpact_program(sandbox,
                            "critical-velocity --law jkr --radius '44 um' --density 2600" + rest + scheme)
              .err == containing("--method"));
    // Beyond a second crossing faster impacts are captured again.
    CHECK(ashimpact_program(
              sandbox,
              "critical-velocity --law thornton-ning --radius '44 um' --density 2600 --contact-modulus "
              "'90 GPa' --work-of-adhesion '0.3 J/m2' --yield-pressure '1 GPa' --damping-law "
              "hunt-crossley --damping '5 s/m'")
              .out == containing("captured again"));
}
