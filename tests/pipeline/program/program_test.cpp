// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/embedded.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::check_refused;
using test::containing;
using test::lines_of;
using test::relative_difference;
using test::Sandbox;

namespace {

const std::string contact =
    " --radius '44 um' --density '2600 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2'";

Json json_of(const Sandbox& sandbox, const std::string& arguments) {
    const auto finished = test::succeeded(sandbox, arguments + " --json");
    return parse_json(finished.out);
}

double value(const Json& quantity) {
    return quantity.at("value").get<double>();
}

constexpr auto with_corundum = "phase,wt%\nquartz,30\nmullite,50\nCorundum,20\n";

}  // namespace

TEST_CASE("help of the program and of every command has an example and the common options") {
    const Sandbox sandbox;
    const auto program = ashimpact_program(sandbox, "--help");
    CHECK(program.status == 0);
    for (const char* command : {"run", "modulus", "impact", "contact", "critical-velocity", "damping",
                                "calibrate", "cross-check", "inspect", "init", "schema"}) {
        CHECK(program.out == containing(command));
        const auto help = ashimpact_program(sandbox, std::string(command) + " --help");
        CHECK(help.status == 0);
        for (const std::string& piece :
             {std::string("Example:\n  "), "ashimpact " + std::string(command), std::string("--quiet"),
              std::string("--verbose"), std::string("--version"), std::string("--color")})
            CHECK(help.out == containing(piece));
        CHECK(ashimpact_program(sandbox, std::string(command) + " --version").out.starts_with("ashimpact "));
    }
}

TEST_CASE("impact: the energies printed add up, with adhesion, damping and yielding") {
    const Sandbox sandbox;
    const std::string ammonium =
        " --radius '2.45 um' --density '1350 kg/m3' --contact-modulus '1.3 GPa' --work-of-adhesion '0.2 "
        "J/m2'";
    for (const std::string& law :
         {std::string("jkr --damping '1e-7 kg/s'"), std::string("dmt --damping '1e-7 kg/s'"),
          std::string("thornton-ning --yield-pressure '35.3 MPa'")}) {
        CAPTURE(law);
        const auto run =
            test::succeeded(sandbox, fmt::format("impact --velocity '5 m/s' --law {}{}", law, ammonium));
        const double mass = 1350 * 4.0 / 3.0 * std::numbers::pi * std::pow(2.45e-6, 3);
        const std::string incident = fmt::format(" {:.3f} pJ", 1e12 * 0.5 * mass * 25.0);
        double before = 0;
        double after = 0;
        std::istringstream lines(run.out);
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("incident energy")) CHECK_MESSAGE(line.ends_with(incident), line);
            for (const char* term : {"incident energy", "  at first touch", "  dissipated",
                                     "  spent in yielding", "  left in motion", "  left in the contact"}) {
                if (!line.starts_with(term)) continue;
                const double value = std::stod(line.substr(std::string(term).size()));
                (term == std::string("incident energy") || term == std::string("  at first touch") ? before
                                                                                                   : after) +=
                    value;
            }
        }
        CHECK(before > 0);
        CHECK(std::abs(before - after) < 1e-9 * before);
    }
}

TEST_CASE("impact --json: the contract's keys, and the reference impact of the solver's tests") {
    const Sandbox sandbox;
    const Json json = json_of(sandbox,
                              "impact --law hertz --velocity '2 m/s' --damping '0.005 kg/s' --radius '44 um' "
                              "--density '2600 kg/m3' --contact-modulus '90 GPa'");
    for (const char* key : {"law", "detachment", "outcome", "restitution", "contact_time", "approach_time",
                            "maximum_overlap", "rebound_velocity", "energy"})
        CHECK_MESSAGE(json.contains(key), key);
    CHECK(json["law"] == "hertz");
    CHECK(json["detachment"] == "zero-overlap");
    CHECK(json["outcome"] == "rebound");
    // Independent integration in the time domain (DOP853, rtol 1e-12).
    CHECK(relative_difference(value(json["restitution"]), 0.54537600512) < 1e-10);
    CHECK(relative_difference(value(json["contact_time"]), 2.0182211196e-07) < 1e-10);
    CHECK(relative_difference(value(json["maximum_overlap"]), 1.0339782822e-07) < 1e-10);
    CHECK(relative_difference(value(json["rebound_velocity"]), 2 * 0.54537600512) < 1e-10);
}

TEST_CASE("impact --json: a capture has restitution 0 and no contact time") {
    const Sandbox sandbox;
    const Json json =
        json_of(sandbox, "impact --law dmt --velocity '0.5 m/s' --damping '0.0153 kg/s'" + contact);
    CHECK(json["outcome"] == "capture");
    CHECK(value(json["restitution"]) == 0);
    CHECK(json["contact_time"].is_null());
    CHECK(value(json["maximum_overlap"]) > 0);
    const Json never =
        json_of(sandbox, "impact --law dmt --velocity '0.01 m/s' --damping '0.0153 kg/s'" + contact);
    CHECK(never["approach_time"].is_null());
    CHECK(value(never["maximum_overlap"]) > 0);
}

TEST_CASE("numbers of --json have 17 significant digits") {
    const Sandbox sandbox;
    const auto finished = ashimpact_program(
        sandbox, "impact --law hertz --velocity 2 --damping 0.005 --json" + contact + " -q");
    CHECK(finished.out == containing("\"value\": 0.0050000000000000001"));
    CHECK(finished.err.empty());
}

TEST_CASE("mass and density say the same of a sphere") {
    const Sandbox sandbox;
    const double mass = 2600 * 4.0 / 3.0 * M_PI * std::pow(44e-6, 3);
    char text[64];
    std::snprintf(text, sizeof text, "%.17g kg", mass);
    const std::string common =
        " --law dmt --velocity 2 --radius '44 um' --contact-modulus '90 GPa' --work-of-adhesion 0.3";
    const Json by_density = json_of(sandbox, "impact --density 2600" + common);
    const Json by_mass = json_of(sandbox, std::string("impact --mass '") + text + "'" + common);
    CHECK(relative_difference(value(by_density["contact_time"]), value(by_mass["contact_time"])) < 1e-14);
}

TEST_CASE("damping and critical-velocity are the inverses of impact") {
    const Sandbox sandbox;
    const Json damping =
        json_of(sandbox, "damping --law brach-dunn --velocity 2 --restitution 0.2" + contact);
    char eta[64];
    std::snprintf(eta, sizeof eta, "%.17g", value(damping["damping"]));
    const Json impact =
        json_of(sandbox, std::string("impact --law brach-dunn --velocity 2 --damping ") + eta + contact);
    CHECK(relative_difference(value(impact["restitution"]), 0.2) < 1e-9);

    const Json critical =
        json_of(sandbox, std::string("critical-velocity --law brach-dunn --damping ") + eta + contact);
    CHECK(critical["verdict"] == "finite");
    for (const auto& [factor, outcome] : {std::pair{1 - 1e-6, "capture"}, std::pair{1 + 1e-6, "rebound"}}) {
        char velocity[64];
        std::snprintf(velocity, sizeof velocity, "%.17g", factor * value(critical["critical_velocity"]));
        const Json at = json_of(sandbox, std::string("impact --law brach-dunn --velocity ") + velocity +
                                             " --damping " + eta + contact);
        CHECK(at["outcome"] == outcome);
    }
    const Json hertz = json_of(
        sandbox,
        "critical-velocity --law hertz --damping 0 --radius 44e-6 --density 2600 --contact-modulus 9e10");
    CHECK(hertz["verdict"] == "never-captured");
    CHECK(hertz["critical_velocity"].is_null());
}

TEST_CASE("the trajectory is a CSV with units in its heading, from touch to detachment") {
    const Sandbox sandbox;
    test::succeeded(sandbox, "impact --law jkr --velocity 2 --trajectory t.csv --points 11" + contact);
    const auto lines = test::lines_of(sandbox.read("t.csv"));
    REQUIRE(lines.size() == 12);
    CHECK(lines[0].starts_with("time [s],overlap [m],velocity [m/s],"));
    CHECK(lines[1].starts_with("0,"));
    CHECK(sandbox.everything().size() == 1);
}

TEST_CASE("the paper's explicit scheme comes nearer to the exact impact with its time step") {
    const Sandbox sandbox;
    const std::string impact = "impact --law dmt --velocity 2 --damping 0.005" + contact;
    const double exact = value(json_of(sandbox, impact)["restitution"]);
    const auto error = [&](const std::string& time_step) {
        const Json json =
            json_of(sandbox, impact + " --method paper-explicit --time-step '" + time_step + "'");
        CHECK(json["method"] == "paper-explicit");
        return std::abs(value(json["restitution"]) - exact);
    };
    CHECK(error("2 ns") > 1e-3);
    CHECK(error("0.02 ns") < 1e-4);
    CHECK(error("0.0002 ns") < 1e-6);
    CHECK(value(json_of(sandbox, impact + " --method paper-explicit")["time_step"]) < 1e-10);
}

TEST_CASE("modulus: an XRD table gives fractions both ways and a modulus with bounds") {
    const Sandbox sandbox;
    sandbox.write("ash.csv", "phase,weight %\nquartz,3.1748\nmullite,96.8252\n");
    check_refused(sandbox, "modulus ash.csv", "allowed: --amorphous-fraction X");
    const Json json = json_of(sandbox, "modulus ash.csv --amorphous-fraction 0.4793 --phase-set dong2013");
    REQUIRE(json["phases"].size() == 3);
    CHECK(json["phases"][0]["name"] == "quartz");
    double weight = 0;
    double volume = 0;
    for (const auto& phase : json["phases"]) {
        weight += phase["weight_fraction"].get<double>();
        volume += phase["volume_fraction"].get<double>();
    }
    CHECK(relative_difference(weight, 1) < 1e-14);
    CHECK(relative_difference(volume, 1) < 1e-14);
    CHECK(std::abs(value(json["young_modulus"]) - 148.13e9) < 0.01e9);  // the paper's 88 um
    CHECK(value(json["bounds"]["lower"]) < value(json["young_modulus"]));
}

TEST_CASE("modulus: every way to state the amorphous part gives the same sample") {
    const Sandbox sandbox;
    sandbox.write("mixture.csv", with_corundum);
    sandbox.write("ash.csv", "phase,wt%\nquartz,37.5\nmullite,62.5\n");
    sandbox.write("whole.csv", "phase,wt%\nquartz,16.6666666667\nmullite,27.7777777778\n");
    // c_s = 0.2, w_s = 0.1: p = 0.1/(0.2 0.9) = 5/9, of which quartz 0.3 and mullite 0.5: 4/9 are crystalline
    for (const std::string options :
         {"mixture.csv --internal-standard corundum --added-fraction '10 %'",
          "mixture.csv --internal-standard Korund --added-fraction '10 %'",
          "ash.csv --amorphous-fraction 0.55555555556", "ash.csv --crystalline-total '44.444444444 %'",
          "whole.csv --amorphous-fraction remainder"}) {
        CAPTURE(options);
        const Json phases = json_of(sandbox, "modulus " + options)["phases"];
        REQUIRE(phases.size() == 3);
        CHECK(phases[2]["name"] == "glass");
        CHECK(relative_difference(phases[0]["weight_fraction"].get<double>(), 1.0 / 6) < 1e-9);
        CHECK(relative_difference(phases[2]["weight_fraction"].get<double>(), 5.0 / 9) < 1e-9);
    }
    CHECK(json_of(sandbox, "modulus ash.csv --amorphous-fraction none")["phases"].size() == 2);
    const auto refused = [&](const std::string& options) {
        const auto finished = ashimpact_program(sandbox, "modulus mixture.csv " + options);
        CHECK(finished.status == 2);
        return finished.err;
    };
    CHECK(refused("") == containing("or --internal-standard PHASE with --added-fraction X"));
    CHECK(refused("--internal-standard corundum") == containing("one is given without the other"));
    CHECK(refused("--internal-standard zincite --added-fraction 0.1") ==
          containing("is not among the phases"));
    CHECK(refused("--amorphous-fraction 42") == containing("--amorphous-fraction: the fraction is 42"));
    CHECK(refused("--amorphous-fraction much") == containing("\"much\" does not start with a number"));
    CHECK(refused("--amorphous-fraction '47,5 %'") == containing("write \"47.5 %\""));
    CHECK(refused("--amorphous-fraction 0.4 --crystalline-total 0.6") == containing("given in 2 ways"));
}

TEST_CASE("modulus: uncertainty of the amorphous part, pores, a measured density, own phases") {
    const Sandbox sandbox;
    sandbox.write("ash.csv", "phase,wt%\nQuartz low,100\n");
    sandbox.write("own.json", R"({"phases": [
        {"name": "quartz", "density": "2.5 g/cm3", "young_modulus": "100 GPa", "poisson_ratio": 0.1},
        {"name": "glass", "amorphous": true, "density": "2.5 g/cm3", "young_modulus": "50 GPa", "poisson_ratio": 0.2}]})");
    // densities are equal, so volumes are weights: E = 100 - 50 x, and 50 u(x) = 1 GPa joins 4 % of each
    // modulus, whose uncertainty nobody states
    const std::string command = "modulus ash.csv --phases own.json --amorphous-fraction '40 +- 2 %'";
    const Json dense = json_of(sandbox, command);
    CHECK(succeeded(sandbox, command).err != containing("--phases"));
    sandbox.write("both.json", R"([{"name": "Quarz", "density": "2.5 g/cm3", "young_modulus": "100 GPa"},
                                   {"name": "glass", "amorphous": true, "density": 2500, "young_modulus": "50 GPa"}])");
    CHECK(succeeded(sandbox, "modulus ash.csv --phases both.json --amorphous-fraction '40 %'").err ==
          containing("--phases: no sample has \"Quarz\", so it changes nothing"));
    CHECK(relative_difference(value(dense["young_modulus"]), 80e9) < 1e-13);
    const double spread = 1e9 * std::sqrt(1 + 2.4 * 2.4 + 0.8 * 0.8);
    CHECK(relative_difference(dense["young_modulus"]["standard_uncertainty"].get<double>(), spread) < 1e-8);
    CHECK(dense["warnings"][0] == "\"Quartz low\" is quartz: quartz of the set user is taken");

    const std::string porous = command + " --porosity-law coble-kingery";
    // P = 1 - 2/2.5 = 0.2, f = 1 - 0.38 + 0.036
    const Json measured = json_of(sandbox, porous + " --particle-density '2 g/cm3'");
    CHECK(relative_difference(measured["porosity"].get<double>(), 0.2) < 1e-14);
    CHECK(relative_difference(value(measured["young_modulus"]), 0.656 * 80e9) < 1e-13);
    CHECK(relative_difference(value(measured["bounds"]["lower"]), 0.656 * value(dense["bounds"]["lower"])) <
          1e-13);
    const Json stated = json_of(sandbox, porous + " --porosity '20 %'");
    CHECK(relative_difference(value(stated["particle_density"]), 2000) < 1e-13);
    const auto text = ashimpact_program(sandbox, porous + " --porosity 0.1 --particle-density '2 g/cm3'");
    CHECK(text.status == 0);
    CHECK(text.err == containing("the measured density gives a porosity of 0.2, stated is 0.1"));
    CHECK(text.out == containing("density of the particle"));
    CHECK(text.out == containing("Eq. 1, no bound"));
    CHECK(ashimpact_program(sandbox, porous).err ==
          containing("--porosity, --particle-density: neither is given"));
    CHECK(ashimpact_program(sandbox, command + " --porosity 0.1").err ==
          containing("--porosity-law: is missing"));
    CHECK(ashimpact_program(sandbox, porous + " --particle-density 3000").err ==
          containing("--particle-density: the apparent density 3000 kg/m3 is above"));
}

TEST_CASE("run takes the same files, groups, synonyms of own phases, and the porosity from the density") {
    const Sandbox sandbox;
    sandbox.write("ash.csv", "phase,wt%\nPlagioclase,40\nQuartz low,60\n");
    sandbox.write("case.json", R"({"name": "c", "laws": ["hertz"], "wall": {"rigid": true},
        "phases": [{"name": "quartz", "density": "2.7 g/cm3", "young_modulus": "100 GPa", "poisson_ratio": 0.1}],
        "samples": [{"name": "a", "diameter": "50 um", "density": "2.0 g/cm3", "porosity": {"law": "gibson-ashby"},
                     "composition": {"xrd": "ash.csv", "amorphous": "none"}}]})");
    test::succeeded(sandbox, "run case.json -o r");
    const Json first = sandbox.json("r/0-case.json");
    CHECK(first["warnings"].dump() == containing("anorthite is used"));
    CHECK(first["warnings"].dump() == containing("quartz of the set user is taken"));
    const Json modulus = sandbox.json("r/1-modulus.json")["result"]["samples"][0];
    const double dense = value(modulus["density"]);
    CHECK(relative_difference(dense, 1 / (0.4 / 2730 + 0.6 / 2700)) < 1e-13);
    const double parallel = value(modulus["rules"]["parallel"]);
    CHECK(relative_difference(value(modulus["young_modulus"]), parallel * 4e6 / (dense * dense)) < 1e-13);
    const Json contact = sandbox.json("r/2-contact.json")["result"]["samples"][0];
    CHECK(value(contact["density"]) == 2000);
    CHECK(relative_difference(value(contact["density_from_phases"]), dense) < 1e-13);
    sandbox.write("ash.csv", "phase,wt%\nPlagioclase,40\nQarz,60\n");
    check_refused(sandbox, "run case.json -o r",
                  "/samples/0/composition: ash.csv: line 3: no phase is called");
}

TEST_CASE("laws lists every law of the registries, a line each") {
    const Sandbox sandbox;
    const auto lines = lines_of(ashimpact_program(sandbox, "laws").out);
    const Json json = json_of(sandbox, "laws");
    REQUIRE(json["laws"].size() == Law::count());
    REQUIRE(json["damping_laws"].size() == all_values<DampingLaw>.size());
    for (const char* kind : {"laws", "damping_laws"})
        for (const Json& law : json[kind]) {
            const auto word = [&](const char* key) { return law[key].get<std::string>(); };
            CHECK(std::ranges::any_of(lines, [&](const std::string& line) {
                return line.starts_with("  " + word("name") + "  ") && line.ends_with("  " + word("summary"));
            }));
        }
    CHECK(json["laws"][0]["name"] == Law::at(0).name());
    CHECK(json["laws"].back()["parameters"][0] == "tabor");
}

TEST_CASE("run with nothing given: the paper's samples, a table, the artifacts") {
    const Sandbox sandbox;
    const auto& first = test::put_built_in_run(sandbox);
    CHECK(lines_of(first.out)[2] == "Particles of 88 um stick below 1.86 m/s.");
    CHECK(lines_of(first.out)[5].starts_with("By maugis-dugdale, one law for all sizes: "));
    CHECK(first.out == containing("\nA reproduction: "));
    CHECK(first.out != containing("95 %"));  // none of the intervals has a known probability
    CHECK(first.out == containing("148.13 (148.13)"));
    for (const char* heading : {"E [GPa]", "E* [GPa]", "W_s [fJ]", "v_c, adhesion only", "dynamic v_c",
                                "by inputs", "published", "measured"})
        CHECK(first.out == containing(heading));
    CHECK(first.out != containing("extrapolated"));  // nothing was measured: an empty column
    int intervals = 0;
    for (const std::string& line : lines_of(first.out)) {
        const auto law = line.find("  brach-dunn  ");  // a row of a table
        if (law != std::string::npos && line.find(" to ") != std::string::npos) ++intervals;
    }
    CHECK(intervals == 3);  // one for each sample
    CHECK(first.out == containing("dissipation does, which takes"));
    CHECK(first.out == containing("results"));
    const Json manifest = sandbox.json("results/manifest.json");
    for (const auto& artifact : manifest["result"]["artifacts"]) {
        const std::string bytes = sandbox.read("results/" + artifact["file"].get<std::string>());
        CHECK(artifact["sha256"] == sha256(bytes));
        CHECK(artifact["bytes"] == bytes.size());
    }
    const Json damping = sandbox.json("results/5-damping.json");
    for (const auto& input : damping["provenance"]["inputs"])
        CHECK(input["sha256"] == sha256(sandbox.read("results/" + input["file"].get<std::string>())));
}

TEST_CASE("run --from an edited artifact uses the edit, and gives the same again without one") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    const auto before = sandbox.everything();
    const double velocity = value(
        sandbox.json("results/comparison.json")["result"]["samples"][0]["dynamic_critical_velocity"]["dmt"]);

    const Json unedited = sandbox.json("results/7-critical-velocity.json");
    test::succeeded(sandbox, "run --from fit");
    CHECK(sandbox.json("results/7-critical-velocity.json") == unedited);

    Json fit = sandbox.json("results/6-fit.json");
    for (const char* key : {"c", "critical_damping"}) {
        Json& damping = fit["result"]["samples"][0]["dmt"][key];
        damping["value"] = 1.01 * value(damping);
    }
    sandbox.write("results/6-fit.json", fit.dump());
    test::succeeded(sandbox, "run --from critical-velocity");
    const double edited = value(
        sandbox.json("results/comparison.json")["result"]["samples"][0]["dynamic_critical_velocity"]["dmt"]);
    CHECK(std::log(edited / velocity) / std::log(1.01) ==
          doctest::Approx(3.9).epsilon(0.15));  // d ln v_c/d ln eta
    CHECK(sandbox.read("results/5-damping.json") == before[6].second);
}

TEST_CASE("run --only writes one artifact and the manifest") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    const auto before = sandbox.everything();
    test::succeeded(sandbox, "run --only damping");
    const auto after = sandbox.everything();
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].first != "results/manifest.json") CHECK(before[i] == after[i]);
    const Json manifest = sandbox.json("results/manifest.json");
    for (const auto& artifact : manifest["result"]["artifacts"])
        CHECK(artifact["written_by_this_run"] == (artifact["stage"] == "damping"));
}

TEST_CASE("inspect shows an artifact with empty texts and refuses a quantity without a unit") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    Json contact = sandbox.json("results/2-contact.json");
    contact["provenance"]["options"]["x"] = "";
    contact["result"]["samples"][0]["contact_modulus"] = "";
    sandbox.write("empty.json", contact.dump());
    const auto shown = ashimpact_program(sandbox, "inspect empty.json");
    CHECK_MESSAGE(shown.status == 0, shown.err);
    CHECK(shown.out == containing("\"\""));

    Json whole = sandbox.json("results/0-case.json");
    REQUIRE(whole["result"]["phases"][0].contains("density"));
    whole["result"]["phases"][0]["density"] = {{"value", 2650}, {"unit", nullptr}};
    sandbox.write("unit.json", whole.dump());
    const auto refused = ashimpact_program(sandbox, "inspect unit.json");
    CHECK(refused.status == 2);
    CHECK(refused.out.empty());
    CHECK_MESSAGE(refused.err == "unit.json: /result/phases/0/density/unit: is null; allowed: a string\n",
                  refused.err);
}

TEST_CASE("schema prints what a case is checked against, comments included") {
    const Sandbox sandbox;
    const auto names = ashimpact_program(sandbox, "schema");
    CHECK(names.out == containing("case\n"));
    for (const std::string& name : test::lines_of(names.out)) {
        const auto schema = ashimpact_program(sandbox, "schema " + name);
        CHECK(schema.status == 0);
        CHECK(parse_json(schema.out)["$schema"] == "http://json-schema.org/draft-07/schema#");
    }
    CHECK(ashimpact_program(sandbox, "schema case").out == containing("\"^//\""));
}

TEST_CASE("impact and critical-velocity tell the regime, and warn of a law out of its range") {
    const Sandbox sandbox;
    const std::string soft =
        " --radius '44 um' --density 2600 --contact-modulus '1 GPa' --work-of-adhesion '0.3 J/m2'";
    const auto impact = ashimpact_program(sandbox, "impact --law dmt --velocity 2" + soft);
    CHECK(impact.status == 0);
    CHECK(impact.out == containing("Tabor parameter"));
    CHECK(impact.out == containing("beta = "));
    CHECK(impact.err == containing("warning: Tabor parameter"));
    CHECK(ashimpact_program(sandbox, "impact --law dmt --velocity 2 -q" + soft).err.empty());
    for (const std::string command : {"impact --velocity 2", "critical-velocity --damping 0.002"}) {
        const Json regime = json_of(sandbox, fmt::format("{} --law jkr{}", command, soft))["regime"];
        CHECK(regime["adhesion"] == "jkr");
        CHECK(regime["warnings"].empty());
        CHECK(regime["tabor_parameter"].get<double>() > 5);
        CHECK(regime["yield_velocity"].is_null());
    }
    const Json yielding = json_of(
        sandbox, "impact --law thornton-ning --velocity 2 --yield-pressure '10 MPa'" + soft)["regime"];
    CHECK(value(yielding["yield_velocity"]) > 0);
    CHECK(yielding["yields"] == true);
}

TEST_CASE("damping --impacts reads a table: damping of each, fits, measured critical velocity") {
    const Sandbox sandbox;
    test::succeeded(sandbox, "init .");
    const std::string arguments =
        "damping --law brach-dunn --impacts impacts.csv --frame-rate 80000 "
        "--pixel-size '2 um'" +
        contact;
    const Json json = json_of(sandbox, arguments);
    CHECK(json["captures"] == 2);
    CHECK(json["inversion"]["damping"]["values"].size() == 10);
    CHECK(json["inversion"]["damping_uncertainty"]["values"].size() == 10);
    CHECK(value(json["measured"]["critical_velocity"]) > 1.55);
    CHECK(value(json["measured"]["critical_velocity"]) < 1.72);
    const auto words = ashimpact_program(sandbox,
                                         "damping --law dmt --impacts impacts.csv --frame-rate fast "
                                         "--pixel-size '2 um'" +
                                             contact);
    CHECK(words.status == 2);
    CHECK(words.err == containing("--frame-rate: "));
    CHECK(words.err == containing("frames per second"));
    const auto blind = ashimpact_program(sandbox,
                                         "damping --law dmt --impacts impacts.csv --frame-rate 80000 "
                                         "--pixel-size '1 m'" +
                                             contact);
    CHECK(blind.status == 2);
    CHECK(blind.err ==
          containing("--frame-rate, --pixel-size: the standard uncertainty of v_in is at least"));
    const auto text = ashimpact_program(sandbox, arguments);
    CHECK(text.out == containing("measured v_c"));
    CHECK(text.out == containing("at least "));  // the damping that captures
    CHECK(text.out == containing("chi^2"));
}

TEST_CASE("damping --impacts: a bound with its number, and no chi^2 where the noise is not known") {
    const Sandbox sandbox;
    test::succeeded(sandbox, "init .");
    const std::string arguments = "damping --law brach-dunn --impacts ";
    const auto text = ashimpact_program(sandbox, arguments + "impacts.csv" + contact);
    CHECK(text.out == containing("extrapolated   "));
    CHECK(text.out != containing("chi^2"));
    const Json json = json_of(sandbox, arguments + "impacts.csv" + contact);
    CHECK(json["extrapolated"]["chi_squared"].is_null());
    CHECK(json["extrapolated"]["probability"].is_null());
    // Which damping explains them, as a run says it.
    CHECK(text.out == containing("Which damping explains the impacts, by brach-dunn: constants for all"));
    CHECK(json["dampings"]["law"] == "brach-dunn");
    REQUIRE(json["dampings"]["laws"].size() == 5);
    for (const Json& damping : json["dampings"]["laws"]) CHECK(damping["misfit"] > 0.0);

    sandbox.write("captured.csv", "velocity [m/s],rebound_velocity [m/s]\n0.9,0\n1.2,0\n");
    const auto captured = ashimpact_program(sandbox, arguments + "captured.csv" + contact);
    CHECK(captured.out == containing("v_c > 1.2 m/s: every impact was captured"));
    CHECK(captured.out != containing("Which damping"));
    sandbox.write("rebounds.csv", "velocity [m/s],rebound_velocity [m/s]\n1.9,0.3\n2.2,0.5\n");
    const auto rebounds = ashimpact_program(sandbox, arguments + "rebounds.csv" + contact);
    CHECK(rebounds.out == containing("v_c < 1.9 m/s: no impact was captured"));
    sandbox.write("fast.csv", "v_in,v_r,u(v_in),u(v_r)\n1.9,0.3,0.03,0.03\n2.2,2.23,0.03,0.03\n");
    const auto fast = ashimpact_program(sandbox, arguments + "fast.csv" + contact);
    CHECK(fast.out == containing("none gives it                  -"));
}

TEST_CASE("damping --robust: outliers that hide the rising branch leave none, as JSON and as text") {
    const Sandbox sandbox;
    sandbox.write("scattered.csv",
                  "v_in [m/s],v_r [m/s],u(v_in) [m/s],u(v_r) [m/s]\n2.8,0.64,0.03,0.03\n1,0.72,0.03,0.03\n"
                  "3.9,1.2,0.03,0.03\n8.8,4,0.03,0.03\n8.3,3.7,0.03,0.03\n2.1,0.29,0.03,0.03\n"
                  "6.1,4,0.03,0.03\n0.97,0.67,0.03,0.03\n");
    for (const std::string law : {"hertz", "brach-dunn"}) {
        CAPTURE(law);
        const std::string arguments = "damping --law " + law +
                                      " --robust --impacts scattered.csv --diameter '88 um' "
                                      "--density '2160 kg/m3' --contact-modulus '100 GPa'" +
                                      (law == "hertz" ? "" : " --work-of-adhesion '0.3 J/m2'");
        const Json json = json_of(sandbox, arguments);
        CHECK(json["rising_branch"].is_null());
        CHECK(json["extrapolated"]["rebounds"] == 8);
        const auto text = ashimpact_program(sandbox, arguments);
        CHECK(text.out == containing("rising branch       hidden by outliers"));
        CHECK(text.err == containing("outliers hide the"));
    }
}

TEST_CASE("cross-check: the published fits of one sample imply nearly the same impacts") {
    const Sandbox sandbox;
    const Json json = json_of(sandbox, "cross-check");
    REQUIRE(json["samples"].size() == 3);
    for (const Json& sample : json["samples"]) {
        CHECK(sample["reference_law"] == "brach-dunn");
        for (const char* law : {"hertz", "dmt"}) {
            const Json& other = sample["predictions"][law];
            CHECK(other["greatest_difference_in_restitution"].get<double>() < 0.5);
            CHECK(other["greatest_difference_in_restitution"].get<double>() > 0);
            CHECK(value(other["predicted"]["c"]) > 0);
            CHECK(value(other["predicted_critical_velocity"]) > 0);
        }
    }
    const auto text = ashimpact_program(sandbox, "cross-check");
    CHECK(text.out == containing("predicted"));
    test::succeeded(sandbox, "init .");
    CHECK(ashimpact_program(sandbox, "cross-check case.json").status == 2);
}

// Calibrations take minutes with sanitizers; tests/solver/calibration runs the same code with them.
TEST_CASE("calibrate finds constants that reproduce the published velocities" *
          doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    const Json json = json_of(sandbox, "calibrate");
    REQUIRE(json["constants"].size() >= 3);
    REQUIRE(json["critical_velocities"].size() == 9);
    REQUIRE(json["contact_times"].size() == 3);
    for (const auto& constant : json["constants"]) {
        CHECK(value(constant["interval_95"][0]) < value(constant["value"]));
        CHECK(value(constant["value"]) < value(constant["interval_95"][1]));
        CHECK(constant["profile"]["identifiable"] == true);
        CHECK(value(constant["profile"]["interval"]["lower"]) < value(constant["value"]));
        CHECK(value(constant["profile"]["interval"]["upper"]) > value(constant["value"]));
    }
    for (const auto& row : json["critical_velocities"])
        CHECK(std::abs(row["relative_difference"].get<double>()) < 0.01);
    for (const auto& row : json["contact_times"])
        CHECK(std::abs(row["relative_difference"].get<double>()) < 0.03);

    // The built-in case carries these constants, to its printed digits.
    test::put_built_in_run(sandbox);
    const Json samples = sandbox.json("results/2-contact.json")["result"]["samples"];
    int compared = 0;
    for (const auto& constant : json["constants"]) {
        const std::string quantity = constant["quantity"];
        const double half_digit = quantity == "density" ? 0.05 : 0.00005;
        for (const auto& sample : samples) {
            if (!constant["sample"].is_null() && constant["sample"] != sample["name"]) continue;
            CHECK(std::abs(value(sample[quantity]) - value(constant["value"])) <= 1.001 * half_digit);
            ++compared;
        }
    }
    CHECK(compared == 6);  // w for three samples, a density for each
}

TEST_CASE("calibrate's table says which constants the published values do not fix" *
          doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    Json document = parse_json(embedded_file("cases/dong2013/case.json").value());
    Json paper = parse_json(embedded_file("published/dong2013.json").value());
    for (auto& [name, sample] : paper["samples"].items()) sample.erase("contact_times");
    document["published"] = "paper.json";
    sandbox.write("paper.json", paper.dump());
    sandbox.write("case.json", document.dump());
    const auto finished = test::succeeded(
        sandbox, "calibrate case.json --free work_of_adhesion --free contact_modulus --free density");
    const auto row_of = [&](const std::string& constant) {
        for (const std::string& line : lines_of(finished.out))
            if (line.starts_with(constant + " ")) return line;
        return std::string();
    };
    CHECK(row_of("work_of_adhesion") == containing(" to "));
    CHECK(row_of("work_of_adhesion") != containing("not identifiable"));
    for (const char* constant : {"contact_modulus", "density"})  // one is traded with the other
        CHECK(row_of(constant) == containing("not identifiable"));
}

TEST_CASE("calibrate --compare sets hypotheses side by side; a finite step is what the tables support most" *
          doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    const Json json = json_of(sandbox, "calibrate --compare");
    REQUIRE(json["hypotheses"].size() == 10);
    CHECK(json["averages"].size() == 4);  // work of adhesion, three densities
    int preferred = 0;
    double least = 1e300;
    double chosen = 0;
    for (const Json& hypothesis : json["hypotheses"]) {
        CAPTURE(hypothesis["hypothesis"]);
        REQUIRE(hypothesis.contains("chi_squared"));
        CHECK(hypothesis["largest_residual"]["observation"].get<std::string>() == containing(" of "));
        const bool rejected = hypothesis["velocities_only"] == true || !hypothesis["captured"].empty();
        if (rejected) {  // moduli that follow the composition do not go with one density
            CHECK(hypothesis["chi_squared"].get<double>() > 100);
            CHECK(std::abs(hypothesis["largest_residual"]["in_uncertainties"].get<double>()) > 5);
            CHECK(hypothesis["hypothesis"].get<std::string>().starts_with("moduli from XRD"));
            CHECK(hypothesis["preferred"] == false);
            continue;
        }
        const double akaike = hypothesis["akaike"];
        CHECK(relative_difference(akaike, hypothesis["chi_squared"].get<double>() +
                                              2 * hypothesis["constants"].get<double>()) < 1e-12);
        least = std::min(least, akaike);
        if (hypothesis["preferred"] == true) {
            ++preferred;
            chosen = akaike;
            CHECK(hypothesis["hypothesis"].get<std::string>() == containing("a finite step"));
        }
    }
    CHECK(preferred == 1);
    CHECK(chosen == least);
    CHECK(ashimpact_program(sandbox, "calibrate --compare --free density").status == 2);
    test::succeeded(sandbox, "init .");
    CHECK(ashimpact_program(sandbox, "calibrate --compare case.json").status == 2);  // nothing published
}

TEST_CASE("output that cannot be written is an error, not a silent loss") {
    const Sandbox sandbox;
    const std::string impact = "impact --law dmt --velocity 2 --json -q" + contact;
    const auto full =
        ashimpact_program(sandbox, impact + " >/dev/full 2>full.err; echo $? >full.status; true");
    CHECK(full.status == 0);  // of the last command of the line
    CHECK(sandbox.read("full.status") == "2\n");
    CHECK(sandbox.read("full.err").starts_with("standard output: cannot be written"));
    sandbox.write("file", "x");
    const auto into_a_file = ashimpact_program(sandbox, "run -o file");
    CHECK(into_a_file.status == 2);
    CHECK(test::lines_of(into_a_file.err).size() == 1);
    CHECK(sandbox.read("file") == "x");
}

TEST_CASE("a computation that does not converge is exit 3") {
    const Sandbox sandbox;
    const auto finished = ashimpact_program(
        sandbox, "impact --law dmt --velocity 2 --method paper-explicit --time-step '1e-18 s'" + contact);
    CHECK(finished.status == 3);
    CHECK(test::lines_of(finished.err).size() == 1);
    CHECK(finished.err.starts_with("not converged: "));
}

TEST_CASE("an interrupted run leaves whole results: those before it or its own") {
    const Sandbox sandbox;
    test::write_example(sandbox, test::example_under("dmt"));
    test::put_built_in_run(sandbox);
    int interrupted = 0;
    for (int i = 0; i < 16; ++i) {
        const std::string wait = "0." + std::string(i < 8 ? "0" : "") + std::to_string(i < 8 ? i + 2 : 2 * i);
        const std::string which = i % 2 == 0 ? "case.json" : "";
        const std::string program = "'" ASHIMPACT_PROGRAM "' run " + which + " -o results";
        const std::string shell = fmt::format("cd '{}' && timeout -s TERM {} {} >/dev/null 2>&1",
                                              sandbox.folder().string(), wait, program);
        interrupted += std::system(shell.c_str()) == 0 ? 0 : 1;
        const Json manifest = sandbox.json("results/manifest.json");
        REQUIRE(manifest["result"]["artifacts"].size() == 10);
        for (const auto& artifact : manifest["result"]["artifacts"])
            CHECK(artifact["sha256"] ==
                  sha256(sandbox.read("results/" + artifact["file"].get<std::string>())));
        for (const auto& [name, content] : sandbox.everything()) CHECK(name != containing(".tmp"));
    }
    CHECK(interrupted > 0);
}
