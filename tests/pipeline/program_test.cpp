#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "pipeline/files/sha256.hpp"
#include "pipeline/json/schema.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::relative_difference;
using test::Sandbox;

namespace {

const std::string contact =
    " --radius '44 um' --density '2600 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2'";

Json json_of(const Sandbox& sandbox, const std::string& arguments) {
    const auto finished = ashimpact_program(sandbox, arguments + " --json");
    REQUIRE_MESSAGE(finished.status == 0, finished.err);
    return parse_json(finished.out);
}

double value(const Json& quantity) {
    return quantity.at("value").get<double>();
}

}  // namespace

TEST_CASE("help of the program and of every command has an example and the common options") {
    const Sandbox sandbox;
    const auto program = ashimpact_program(sandbox, "--help");
    CHECK(program.status == 0);
    for (const char* command : {"run", "modulus", "impact", "critical-velocity", "damping", "calibrate",
                                "inspect", "init", "schema"}) {
        CHECK_MESSAGE(program.out.find(command) != std::string::npos, command);
        const auto help = ashimpact_program(sandbox, std::string(command) + " --help");
        CHECK(help.status == 0);
        for (const std::string& piece :
             {"Example:\n  ashimpact " + std::string(command), std::string("--quiet"),
              std::string("--verbose"), std::string("--version")})
            CHECK_MESSAGE(help.out.find(piece) != std::string::npos, command, " ", piece);
        CHECK(ashimpact_program(sandbox, std::string(command) + " --version").out.starts_with("ashimpact "));
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
    CHECK(finished.out.find("\"value\": 0.0050000000000000001") != std::string::npos);
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
    const auto finished =
        ashimpact_program(sandbox, "impact --law jkr --velocity 2 --trajectory t.csv --points 11" + contact);
    REQUIRE(finished.status == 0);
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
    const auto refused = ashimpact_program(sandbox, "modulus ash.csv");
    CHECK(refused.status == 2);
    CHECK(refused.err.find("amorphous") != std::string::npos);
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

TEST_CASE("run with nothing given: the paper's samples, a table, the artifacts, deterministic bytes") {
    const Sandbox sandbox;
    const auto first = ashimpact_program(sandbox, "run");
    REQUIRE_MESSAGE(first.status == 0, first.err);
    CHECK(first.out.find("v_c brach-dunn [m/s]") != std::string::npos);
    CHECK(first.out.find("148.13 (148.13)") != std::string::npos);
    CHECK(first.out.find("viscous dissipation does") != std::string::npos);
    CHECK(first.out.find("results") != std::string::npos);
    const auto written = sandbox.everything();
    CHECK(written.size() == 12);  // 11 files and their folder
    const auto second = ashimpact_program(sandbox, "run");
    CHECK(second.out == first.out);
    CHECK(sandbox.everything() == written);

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
    REQUIRE(ashimpact_program(sandbox, "run -o out").status == 0);
    const auto before = sandbox.everything();
    const double velocity = value(
        sandbox.json("out/comparison.json")["result"]["samples"][0]["dynamic_critical_velocity"]["dmt"]);

    const Json unedited = sandbox.json("out/7-critical-velocity.json");
    REQUIRE(ashimpact_program(sandbox, "run -o out --from fit").status == 0);
    CHECK(sandbox.json("out/7-critical-velocity.json") == unedited);

    Json fit = sandbox.json("out/6-fit.json");
    fit["result"]["samples"][0]["dmt"]["critical_damping"]["value"] =
        1.01 * value(fit["result"]["samples"][0]["dmt"]["critical_damping"]);
    sandbox.write("out/6-fit.json", fit.dump());
    REQUIRE(ashimpact_program(sandbox, "run -o out --from critical-velocity").status == 0);
    const double edited = value(
        sandbox.json("out/comparison.json")["result"]["samples"][0]["dynamic_critical_velocity"]["dmt"]);
    CHECK(std::log(edited / velocity) / std::log(1.01) ==
          doctest::Approx(3.9).epsilon(0.15));  // d ln v_c/d ln eta
    CHECK(sandbox.read("out/5-damping.json") == before[6].second);
}

TEST_CASE("run --only writes one artifact and the manifest") {
    const Sandbox sandbox;
    REQUIRE(ashimpact_program(sandbox, "run -o out").status == 0);
    const auto before = sandbox.everything();
    REQUIRE(ashimpact_program(sandbox, "run -o out --only damping").status == 0);
    const auto after = sandbox.everything();
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].first != "out/manifest.json") CHECK(before[i] == after[i]);
    const Json manifest = sandbox.json("out/manifest.json");
    for (const auto& artifact : manifest["result"]["artifacts"])
        CHECK(artifact["written_by_this_run"] == (artifact["stage"] == "damping"));
}

TEST_CASE("init, run and inspect, as the help says") {
    const Sandbox sandbox;
    REQUIRE(ashimpact_program(sandbox, "init my-case").status == 0);
    CHECK(ashimpact_program(sandbox, "init my-case").status == 2);
    const Json commented = sandbox.json("my-case/case.json");
    CHECK(commented.contains("//"));
    const auto run = ashimpact_program(sandbox, "run my-case/case.json -o my-case/results");
    REQUIRE_MESSAGE(run.status == 0, run.err);
    for (const char* file : {"0-case", "1-modulus", "2-contact", "3-analytic", "4-restitution", "5-damping",
                             "6-fit", "7-critical-velocity", "8-histories", "comparison", "manifest"}) {
        const auto shown =
            ashimpact_program(sandbox, std::string("inspect my-case/results/") + file + ".json");
        CHECK_MESSAGE(shown.status == 0, shown.err);
        CHECK_MESSAGE(shown.out.starts_with(std::string(file) + " by ashimpact "), file);
    }
    const auto contact_tables = ashimpact_program(sandbox, "inspect my-case/results/2-contact.json");
    CHECK(contact_tables.out.find("2300 kg/m3") != std::string::npos);
    CHECK(ashimpact_program(sandbox, "inspect my-case/case.json").status == 2);
}

TEST_CASE("schema prints what a case is checked against, comments included") {
    const Sandbox sandbox;
    const auto names = ashimpact_program(sandbox, "schema");
    CHECK(names.out.find("case\n") != std::string::npos);
    for (const std::string& name : test::lines_of(names.out)) {
        const auto schema = ashimpact_program(sandbox, "schema " + name);
        CHECK(schema.status == 0);
        CHECK(parse_json(schema.out)["$schema"] == "http://json-schema.org/draft-07/schema#");
    }
    CHECK(ashimpact_program(sandbox, "schema case").out.find("\"^//\"") != std::string::npos);
}

TEST_CASE("calibrate finds constants that reproduce the published velocities") {
    const Sandbox sandbox;
    const Json json = json_of(sandbox, "calibrate");
    REQUIRE(json["constants"].size() >= 3);
    for (const auto& constant : json["constants"]) {
        CHECK(value(constant["interval_95"][0]) < value(constant["value"]));
        CHECK(value(constant["value"]) < value(constant["interval_95"][1]));
    }
    REQUIRE(json["critical_velocities"].size() == 9);
    REQUIRE(json["contact_times"].size() == 3);
    for (const auto& row : json["critical_velocities"])
        CHECK(std::abs(row["relative_difference"].get<double>()) < 0.03);
    for (const auto& row : json["contact_times"])
        CHECK(std::abs(row["relative_difference"].get<double>()) < 0.03);
}

TEST_CASE("output that cannot be written is an error, not a silent loss") {
    const Sandbox sandbox;
    const std::string impact = "impact --law dmt --velocity 2 --json" + contact;
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
    test::write_example(sandbox, test::example_case());
    REQUIRE(ashimpact_program(sandbox, "run -o out").status == 0);
    int interrupted = 0;
    for (int i = 0; i < 16; ++i) {
        const std::string wait = "0." + std::string(i < 8 ? "0" : "") + std::to_string(i < 8 ? i + 2 : 2 * i);
        const std::string which = i % 2 == 0 ? "case.json" : "";
        const std::string program = "'" ASHIMPACT_PROGRAM "' run " + which + " -o out";
        const std::string shell = "cd '" + sandbox.folder().string() + "' && timeout -s TERM " + wait + " " +
                                  program + " >/dev/null 2>&1";
        interrupted += std::system(shell.c_str()) == 0 ? 0 : 1;
        const Json manifest = sandbox.json("out/manifest.json");
        REQUIRE(manifest["result"]["artifacts"].size() == 10);
        for (const auto& artifact : manifest["result"]["artifacts"])
            CHECK(artifact["sha256"] == sha256(sandbox.read("out/" + artifact["file"].get<std::string>())));
        for (const auto& [name, content] : sandbox.everything())
            CHECK(name.find(".tmp") == std::string::npos);
    }
    CHECK(interrupted > 0);
}
