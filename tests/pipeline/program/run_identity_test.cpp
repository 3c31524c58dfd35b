// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::Sandbox;

namespace {

Json quick_case() {
    Json document = test::example_case();
    while (document["samples"].size() > 1) document["samples"].erase(1);
    document["laws"] = {"hertz"};
    return document;
}

void run_case(const Sandbox& sandbox, const Json& document, const std::string& folder) {
    test::write_example(sandbox, document);
    const auto run = ashimpact_program(sandbox, "run case.json -o " + folder);
    REQUIRE_MESSAGE(run.status == 0, run.err);
}

/// One line, status 2, and the folder as it was.
void check_command_refused(const Sandbox& sandbox, const std::string& arguments, const std::string& says) {
    CAPTURE(arguments);
    const auto before = sandbox.everything();
    const auto finished = ashimpact_program(sandbox, arguments);
    CHECK(finished.status == 2);
    CHECK_MESSAGE(finished.err.find(says) != std::string::npos, finished.err);
    CHECK(sandbox.everything() == before);
}

/// The analytic v_c of the first sample is that of this mass.
void check_analytic_velocity(const Sandbox& sandbox, double mass) {
    const Json analytic = sandbox.json("one/3-analytic.json")["result"]["samples"][0];
    const double energy = analytic["separation_energy"]["value"];
    const double velocity = analytic["critical_velocity"]["value"];
    CHECK(velocity == doctest::Approx(std::sqrt(2 * energy / mass)).epsilon(1e-4));
}

}  // namespace

TEST_CASE("every artifact carries the identity of its run; a mixture of two runs is refused") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    Json other = quick_case();
    other["samples"][0]["diameter"] = "77 um";
    run_case(sandbox, other, "two");
    const std::string run = sandbox.json("one/0-case.json")["provenance"]["run"];
    CHECK(run.size() == 64);
    CHECK(sandbox.json("two/0-case.json")["provenance"]["run"] != run);
    for (const auto& entry : std::filesystem::directory_iterator(sandbox.folder() / "one")) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".json")) continue;
        CAPTURE(name);
        CHECK(sandbox.json("one/" + name)["provenance"]["run"] == run);
        CHECK(sandbox.json("one/" + name)["schema_version"] == 1);
    }
    sandbox.write("one/3-analytic.json", sandbox.read("two/3-analytic.json"));
    check_command_refused(sandbox, "run -o one --from comparison",
                          "one/3-analytic.json: is of another run than 0-case.json beside it");
    check_command_refused(sandbox, "run -o one --only damping", "one/3-analytic.json: is of another run");
}

TEST_CASE("the same case gives the same run and the same bytes") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const auto before = sandbox.everything();
    run_case(sandbox, quick_case(), "one");
    CHECK(sandbox.everything() == before);
    CHECK(ashimpact_program(sandbox, "run -o one --from comparison").status == 0);
    CHECK(sandbox.read("one/comparison.json") ==
          std::find_if(before.begin(), before.end(), [](const auto& file) {
              return file.first == "one/comparison.json";
          })->second);
}

TEST_CASE("an artifact that is not there is named, and no other file") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    std::filesystem::remove(sandbox.path("one/2-contact.json"));
    const auto run = ashimpact_program(sandbox, "run -o one --from analytic");
    CHECK(run.status == 2);
    CHECK_MESSAGE(run.err.find("one/2-contact.json: cannot be read") == 0, run.err);
    CHECK(test::lines_of(run.err).size() == 1);
}

TEST_CASE("an edited artifact is taken and said to be edited; another layout is no edit") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    Json artifact = sandbox.json("one/3-analytic.json");
    sandbox.write("one/3-analytic.json", artifact.dump(7));
    auto run = ashimpact_program(sandbox, "run -o one --only comparison");
    CHECK(run.status == 0);
    CHECK_MESSAGE(run.err.find("edited") == std::string::npos, run.err);

    artifact["result"]["samples"][0]["critical_velocity"]["value"] = 0.25;
    sandbox.write("one/3-analytic.json", artifact.dump());
    run = ashimpact_program(sandbox, "run -o one --only comparison");
    CHECK(run.status == 0);
    CHECK_MESSAGE(
        run.err.find("one/3-analytic.json: was edited after ashimpact wrote it; its values count") !=
            std::string::npos,
        run.err);
    const Json comparison = sandbox.json("one/comparison.json");
    CHECK(comparison["result"]["samples"][0]["analytic_critical_velocity"]["value"] == 0.25);
    CHECK(comparison["warnings"].dump().find("3-analytic.json was edited after ashimpact wrote it") !=
          std::string::npos);
}

TEST_CASE("what cannot be is refused in an edited artifact, with file and place") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json whole = sandbox.json("one/3-analytic.json");
    {
        Json artifact = whole;
        artifact["result"]["samples"][0]["critical_velocity"]["unit"] = "kg";
        sandbox.write("one/3-analytic.json", artifact.dump());
        check_command_refused(
            sandbox, "run -o one --only comparison",
            "one/3-analytic.json: /result/samples/0/critical_velocity: the unit \"kg\" is not one of");
    }
    for (const char* value : {"-2", "1e300"}) {
        Json artifact = whole;
        artifact["result"]["samples"][0]["critical_velocity"]["value"] = Json::parse(value);
        sandbox.write("one/3-analytic.json", artifact.dump());
        check_command_refused(sandbox, "run -o one --only comparison",
                              "one/3-analytic.json: /result/samples/0/critical_velocity/value: is ");
    }
}

TEST_CASE("a value edited without its interval counts, and its interval is dropped with a warning") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json whole = sandbox.json("one/7-critical-velocity.json");
    REQUIRE(whole["provenance"].contains("intervals"));
    const Json entry = whole["provenance"]["intervals"][0];
    const Json::json_pointer at(entry["at"].get<std::string>());
    for (const double factor : {1.001, 3.0}) {  // inside of the interval, and outside of it
        CAPTURE(factor);
        Json artifact = whole;
        Json& object = artifact[at];
        Json& quantity = object.contains("value") ? object : object["critical_velocity"];
        quantity["value"] = factor * entry["value"].get<double>();
        sandbox.write("one/7-critical-velocity.json", artifact.dump());
        const auto run = ashimpact_program(sandbox, "run -o one --only comparison");
        REQUIRE_MESSAGE(run.status == 0, run.err);
        CHECK_MESSAGE(run.err.find("was edited without its interval, which is dropped") != std::string::npos,
                      run.err);
    }
}

TEST_CASE("of values that stand twice in an artifact the other follows the edited one") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json whole = sandbox.json("one/6-fit.json");
    const Json before = sandbox.json("one/7-critical-velocity.json")["result"]["samples"][0]["hertz"];
    REQUIRE(whole["result"]["samples"][0]["hertz"].contains("direct"));
    for (const char* key : {"c", "critical_damping", "direct"}) {
        CAPTURE(key);
        Json artifact = whole;
        Json& fit = artifact["result"]["samples"][0]["hertz"];
        Json& quantity = key == std::string("direct") ? fit["direct"]["critical_damping"] : fit[key];
        const double edited = 1.3 * quantity["value"].get<double>();
        quantity["value"] = edited;
        sandbox.write("one/6-fit.json", artifact.dump());
        const auto run = ashimpact_program(sandbox, "run -o one --from critical-velocity");
        REQUIRE_MESSAGE(run.status == 0, run.err);
        CHECK_MESSAGE(run.err.find("which was edited") != std::string::npos, run.err);
        const Json after = sandbox.json("one/7-critical-velocity.json")["result"]["samples"][0]["hertz"];
        CHECK(after["damping"]["value"] == edited);
        CHECK(after["critical_velocity"]["value"] > before["critical_velocity"]["value"]);
        CHECK(after["critical_velocity"]["interval"].is_null());  // that of another damping
        CHECK(after["interval_note"].get<std::string>().find("states no uncertainty") != std::string::npos);
        for (const char* file :
             {"one/7-critical-velocity.json", "one/8-histories.json", "one/comparison.json"})
            CHECK_MESSAGE(
                sandbox.json(file)["warnings"].dump().find("6-fit.json was edited") != std::string::npos,
                file);
    }
    Json artifact = whole;
    artifact["result"]["samples"][0]["hertz"]["c"]["value"] = 1;
    artifact["result"]["samples"][0]["hertz"]["critical_damping"]["value"] = 2;
    sandbox.write("one/6-fit.json", artifact.dump());
    check_command_refused(sandbox, "run -o one --from critical-velocity", "and both were edited");
    artifact = whole;
    artifact["result"]["samples"][0]["hertz"]["extrapolated"]["coefficients"]["values"][0] = 1;
    sandbox.write("one/6-fit.json", artifact.dump());
    check_command_refused(sandbox, "run -o one --from critical-velocity",
                          "its coefficients are not a, b, c of the fit: c");
}

TEST_CASE("an edited quantity may be in another unit or form, not of another dimension") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json whole = sandbox.json("one/6-fit.json");
    const double written = whole["result"]["samples"][0]["hertz"]["c"]["value"].get<double>();
    const auto with_c = [&](const Json& c) {
        Json artifact = whole;
        artifact["result"]["samples"][0]["hertz"]["c"] = c;
        sandbox.write("one/6-fit.json", artifact.dump());
    };
    const auto damping_of_run = [&] {
        const auto run = ashimpact_program(sandbox, "run -o one --from critical-velocity");
        REQUIRE_MESSAGE(run.status == 0, run.err);
        return sandbox
            .json("one/7-critical-velocity.json")["result"]["samples"][0]["hertz"]["damping"]["value"]
            .get<double>();
    };
    const double edited = 1.3 * written;
    for (const Json& c :
         {Json{{"value", edited}, {"unit", "kg/s"}}, Json{{"value", 1e3 * edited}, {"unit", "g/s"}},
          Json(edited), Json(std::to_string(1e3 * edited) + " g/s")}) {
        CAPTURE(c.dump());
        with_c(c);
        CHECK(damping_of_run() == doctest::Approx(edited).epsilon(1e-6));
    }
    Json c = whole["result"]["samples"][0]["hertz"]["c"];
    c["unit"] = "kg";
    with_c(c);
    check_command_refused(sandbox, "run -o one --from critical-velocity",
                          "one/6-fit.json: /result/samples/0/hertz/c");
    with_c("a lot");
    check_command_refused(sandbox, "run -o one --from critical-velocity",
                          "one/6-fit.json: /result/samples/0/hertz/c");
}

TEST_CASE("an edited fraction is read in any form, and said to change nothing") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json whole = sandbox.json("one/1-modulus.json");
    const auto edited_to = [&](const Json& fraction) {
        Json artifact = whole;
        artifact["result"]["samples"][0]["phases"][0]["weight_fraction"] = fraction;
        sandbox.write("one/1-modulus.json", artifact.dump());
    };
    for (const Json& fraction : {Json("33 %"), Json(0.33), Json{{"value", 33}, {"unit", "%"}}}) {
        CAPTURE(fraction.dump());
        edited_to(fraction);
        const auto run = ashimpact_program(sandbox, "run -o one --only contact");
        REQUIRE_MESSAGE(run.status == 0, run.err);
        CHECK_MESSAGE(
            run.err.find("/result/samples/0/phases/0/weight_fraction: nothing is computed from it") !=
                std::string::npos,
            run.err);
    }
    edited_to("33 um");
    check_command_refused(sandbox, "run -o one --only contact",
                          "one/1-modulus.json: /result/samples/0/phases/0/weight_fraction");
}

TEST_CASE("a damping in an edited artifact is checked though nothing reads it") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json histories = sandbox.json("one/8-histories.json");
    for (const Json& damping :
         {Json{{"value", 1e300}, {"unit", "kg/s"}}, Json{{"value", 0.01}, {"unit", "kg"}},
          Json{{"value", 0.01}, {"unit", "Pa s"}}, Json("much"), Json(1e41)}) {
        CAPTURE(damping.dump());
        Json artifact = histories;
        artifact["result"]["samples"][0]["hertz"].back()["damping"] = damping;
        sandbox.write("one/8-histories.json", artifact.dump());
        check_command_refused(sandbox, "run -o one --only comparison",
                              "one/8-histories.json: /result/samples/0/hertz/");
    }
    sandbox.write("one/8-histories.json", histories.dump());
    Json fit = sandbox.json("one/6-fit.json");
    fit["result"]["samples"][0]["hertz"]["residual_deviation"] = {{"value", 1e300}, {"unit", "kg/s"}};
    sandbox.write("one/6-fit.json", fit.dump());
    check_command_refused(sandbox, "run -o one --from critical-velocity",
                          "one/6-fit.json: /result/samples/0/hertz/residual_deviation");
}

TEST_CASE("an edited density changes the mass, and v_c with it") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    Json artifact = sandbox.json("one/2-contact.json");
    Json& sample = artifact["result"]["samples"][0];
    sample["density"]["value"] = 1.5 * sample["density"]["value"].get<double>();
    const double mass = 1.5 * sample["mass"]["value"].get<double>();
    sandbox.write("one/2-contact.json", artifact.dump());
    const auto run = ashimpact_program(sandbox, "run -o one --from analytic");
    REQUIRE_MESSAGE(run.status == 0, run.err);
    CHECK_MESSAGE(run.err.find("mass: follows radius and density") != std::string::npos, run.err);
    check_analytic_velocity(sandbox, mass);
}

TEST_CASE("an edited mass changes the density, and v_c with it") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    Json artifact = sandbox.json("one/2-contact.json");
    Json& sample = artifact["result"]["samples"][0];
    const double mass = 1.5 * sample["mass"]["value"].get<double>();
    sample["mass"]["value"] = mass;
    sandbox.write("one/2-contact.json", artifact.dump());
    const auto run = ashimpact_program(sandbox, "run -o one --from analytic");
    REQUIRE_MESSAGE(run.status == 0, run.err);
    CHECK_MESSAGE(run.err.find("density: follows the mass") != std::string::npos, run.err);
    check_analytic_velocity(sandbox, mass);
}

TEST_CASE("artifacts and cases of another schema version are refused by version") {
    const Sandbox sandbox;
    run_case(sandbox, quick_case(), "one");
    const Json whole = sandbox.json("one/3-analytic.json");
    Json artifact = whole;
    artifact.erase("schema_version");
    sandbox.write("one/3-analytic.json", artifact.dump());
    check_command_refused(sandbox, "run -o one --only comparison",
                          "\"schema_version\" is missing: an artifact of an earlier");
    artifact["schema_version"] = 2;
    sandbox.write("one/3-analytic.json", artifact.dump());
    check_command_refused(sandbox, "run -o one --only comparison", "/schema_version: is 2; allowed: 1");
    Json document = quick_case();
    document["schema_version"] = 7;
    sandbox.write("case.json", document.dump());
    check_command_refused(sandbox, "run case.json -o two", "case.json: /schema_version: is 7; allowed: 1");
    document["schema_version"] = 1;
    sandbox.write("case.json", document.dump());
    CHECK(ashimpact_program(sandbox, "run case.json -o two").status == 0);
}

TEST_CASE("impossible numbers of a case, a NUL in a name and endless lists are refused with their place") {
    const Sandbox sandbox;
    const auto refused = [&](const char* pointer, const Json& value, const std::string& says) {
        Json document = quick_case();
        document[Json::json_pointer(pointer)] = value;
        test::write_example(sandbox, document);
        check_command_refused(sandbox, "run case.json -o out", says);
    };
    refused("/wall/poisson_ratio", {{"value", 0.3}, {"unit", "1"}, {"standard_uncertainty", 1e30}},
            "case.json: /wall/poisson_ratio/standard_uncertainty: a standard uncertainty of 1e+30; allowed: "
            "0 to 1");
    refused("/samples/0/density", {{"value", 2500}, {"unit", "kg/m3"}, {"standard_uncertainty", 1e308}},
            "case.json: /samples/0/density/standard_uncertainty: a standard uncertainty of 1e+308");
    refused(
        "/samples/0/density", {{"value", 2500}, {"unit", "kg/m3"}, {"standard_uncertainty", 1e6}},
        "case.json: /samples/0/density/standard_uncertainty: is 1e+06; allowed: ten times the value at most");
    refused("/samples/0/restitution/file", std::string("impacts.csv\0x", 13),
            "case.json: /samples/0/restitution/file: holds a NUL character");
    refused("/laws", std::vector<std::string>(10'000, "hertz"), "case.json: /laws: is a list of 10000");
}

TEST_CASE("a case names files of its own folder only, through links too, unless that is allowed") {
    const Sandbox sandbox;
    test::write_example(sandbox, quick_case());
    Json document = quick_case();
    for (const char* name : {"ash.csv", "impacts.csv"})
        sandbox.write(std::string("inside/") + name, sandbox.read(name));
    document["samples"][0]["restitution"]["file"] = "../impacts.csv";
    sandbox.write("inside/case.json", document.dump());
    check_command_refused(sandbox, "run inside/case.json -o out",
                          "impacts.csv: lies outside of the folder of the case");
    CHECK(ashimpact_program(sandbox, "run inside/case.json -o allowed --allow-outside").status == 0);
    for (const std::string command : {"calibrate", "cross-check"}) {
        check_command_refused(sandbox, command + " inside/case.json",
                              "impacts.csv: lies outside of the folder of the case");
        const auto allowed = ashimpact_program(sandbox, command + " inside/case.json --allow-outside");
        CHECK_MESSAGE(allowed.err.find("outside") == std::string::npos, allowed.err);
    }
    std::filesystem::create_symlink("../impacts.csv", sandbox.folder() / "inside/link.csv");
    document["samples"][0]["restitution"]["file"] = "link.csv";
    sandbox.write("inside/case.json", document.dump());
    check_command_refused(sandbox, "run inside/case.json -o out",
                          "link.csv: lies outside of the folder of the case");
    document["samples"][0]["restitution"]["file"] = "impacts.csv";
    sandbox.write("inside/case.json", document.dump());
    CHECK(ashimpact_program(sandbox, "run inside/case.json -o out").status == 0);
}

TEST_CASE("a run whose standard output is closed has written its files, and says so with status 0") {
    const Sandbox sandbox;
    test::write_example(sandbox, quick_case());
    const auto run =
        ashimpact_program(sandbox, "run case.json -o out >/dev/full 2>err; echo $? >status; true");
    CHECK(sandbox.read("status") == "0\n");
    CHECK(sandbox.read("err").find("warning: standard output: cannot be written") != std::string::npos);
    CHECK(sandbox.has("out/comparison.json"));
}
