// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <functional>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::check_refused;
using test::containing;
using test::Sandbox;

namespace {

Json quick_case() {
    return test::with_one_sample(test::example_case(), {"hertz"});
}

void run_case(const Sandbox& sandbox, const Json& document, const std::string& folder) {
    test::write_example(sandbox, document);
    test::succeeded(sandbox, "run case.json -o " + folder);
}

/// Puts the quick case and its results in folder "one" into the sandbox; they are computed once.
void put_quick_run(const Sandbox& sandbox) {
    static const Sandbox made;
    static const bool computed = (run_case(made, quick_case(), "one"), true);
    REQUIRE(computed);
    std::filesystem::copy(made.folder(), sandbox.folder(), std::filesystem::copy_options::recursive);
}

}  // namespace

TEST_CASE("every artifact carries the identity of its run; a mixture of two runs is refused") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
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
    check_refused(sandbox, "run -o one --from comparison",
                  "one/3-analytic.json: is of another run than 0-case.json beside it");
    check_refused(sandbox, "run -o one --only damping", "one/3-analytic.json: is of another run");
}

TEST_CASE("the same case gives the same run and the same bytes") {
    const Sandbox sandbox;
    test::write_example(sandbox, quick_case());
    const auto first = test::succeeded(sandbox, "run case.json -o one");
    const auto before = sandbox.everything();
    CHECK(test::succeeded(sandbox, "run case.json -o one").out == first.out);
    CHECK(sandbox.everything() == before);
    CHECK(ashimpact_program(sandbox, "run -o one --from comparison").status == 0);
    CHECK(sandbox.read("one/comparison.json") ==
          std::find_if(before.begin(), before.end(), [](const auto& file) {
              return file.first == "one/comparison.json";
          })->second);
}

TEST_CASE("an artifact that is not there is named, and no other file") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    std::filesystem::remove(sandbox.path("one/2-contact.json"));
    const auto run = ashimpact_program(sandbox, "run -o one --from analytic");
    CHECK(run.status == 2);
    CHECK_MESSAGE(run.err.find("one/2-contact.json: cannot be read") == 0, run.err);
    CHECK(test::lines_of(run.err).size() == 1);
}

TEST_CASE("an edited artifact is taken and said to be edited; another layout is no edit") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    Json artifact = sandbox.json("one/3-analytic.json");
    sandbox.write("one/3-analytic.json", artifact.dump(7));
    sandbox.write("one/2-contact.json", sandbox.json("one/2-contact.json").dump(7));
    auto run = ashimpact_program(sandbox, "run -o one --only comparison");
    CHECK(run.status == 0);
    CHECK(run.err != containing("edited"));

    artifact["result"]["samples"][0]["critical_velocity"]["value"] = 0.25;
    sandbox.write("one/3-analytic.json", artifact.dump());
    run = ashimpact_program(sandbox, "run -o one --only comparison");
    CHECK(run.status == 0);
    CHECK(run.err ==
          containing("one/3-analytic.json: was edited after ashimpact wrote it; its values count"));
    const Json comparison = sandbox.json("one/comparison.json");
    CHECK(comparison["result"]["samples"][0]["analytic_critical_velocity"]["value"] == 0.25);
    CHECK(comparison["warnings"].dump() == containing("3-analytic.json was edited after ashimpact wrote it"));
}

TEST_CASE("values of an edited modulus beside which the case states its own are said not to count") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    Json artifact = sandbox.json("one/1-modulus.json");
    artifact["result"]["samples"][0]["density"]["value"] = 2345.0;
    sandbox.write("one/1-modulus.json", artifact.dump());
    test::succeeded(sandbox, "run -o one --from contact");
    CHECK(sandbox.json("one/2-contact.json")["warnings"].dump() ==
          containing("density as the case states, not as 1-modulus.json"));
}

TEST_CASE("an edit counts in what follows, which is marked as computed from it") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    const Json before = sandbox.json("one/7-critical-velocity.json");
    CHECK_FALSE(before["provenance"].contains("edited"));
    const auto computed_from_edit = [&](const std::function<void(Json&)>& edit) {
        Json artifact = sandbox.json("one/6-fit.json");
        edit(artifact["result"]["samples"][0]["hertz"]);
        sandbox.write("one/6-fit.json", artifact.dump());
        test::succeeded(sandbox, "run -o one --from critical-velocity");
        for (const char* file :
             {"one/7-critical-velocity.json", "one/8-histories.json", "one/comparison.json"}) {
            CAPTURE(file);
            CHECK(sandbox.json(file)["provenance"]["edited"] == true);
            CHECK(sandbox.json(file)["warnings"].dump() == containing("6-fit.json was edited"));
        }
        return sandbox.json("one/7-critical-velocity.json")["result"]["samples"][0]["hertz"];
    };
    const double estimate = before["result"]["samples"][0]["hertz"]["damping"]["value"];
    CHECK(computed_from_edit([&](Json& fit) {
              fit["direct"]["critical_damping"]["value"] = 1.001 * estimate;
          })["damping"]["value"] == 1.001 * estimate);
    const double edited = 1.3 * estimate;
    for (const Json& c : {Json{{"value", 1e3 * edited}, {"unit", "g/s"}}, Json(edited)}) {
        CAPTURE(c.dump());
        const Json after = computed_from_edit([&](Json& fit) {
            for (const char* key : {"c", "critical_damping"}) fit[key] = c;
            for (const char* part : {"direct", "extrapolated"}) fit.erase(part);
        });
        CHECK(after["damping"]["value"].get<double>() == doctest::Approx(edited).epsilon(1e-12));
        CHECK(after["critical_velocity"]["value"] >
              before["result"]["samples"][0]["hertz"]["critical_velocity"]["value"]);
        CHECK(after["interval_note"].get<std::string>() == containing("states no uncertainty"));
    }
}

TEST_CASE("the damping of an estimate alone can be edited, in all places that state it") {
    const Sandbox sandbox;
    run_case(sandbox, test::with_one_sample(test::example_case(), {"maugis-dugdale"}), "one");
    Json artifact = sandbox.json("one/6-fit.json");
    Json& fit = artifact["result"]["samples"][0]["maugis-dugdale"];
    REQUIRE(fit["method"] == "estimate");
    const double edited = 1.2 * fit["c"]["value"].get<double>();
    const std::string again = "run -o one --from critical-velocity";
    fit["direct"]["critical_damping"]["value"] = edited;
    fit["direct"].erase("critical_damping_interval");
    sandbox.write("one/6-fit.json", artifact.dump());
    check_refused(sandbox, again, "is not the critical damping of \"direct\"");
    for (const char* key : {"c", "critical_damping"}) fit[key]["value"] = edited;
    sandbox.write("one/6-fit.json", artifact.dump());
    test::succeeded(sandbox, again);
    const Json after = sandbox.json("one/7-critical-velocity.json")["result"]["samples"][0]["maugis-dugdale"];
    CHECK(after["damping"]["value"].get<double>() == doctest::Approx(edited).epsilon(1e-12));
}

TEST_CASE("an edited artifact is refused in one line where it cannot be or contradicts itself") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    struct Edit {
        const char* file;
        const char* pointer;
        Json value;
        const char* stage;
        const char* says;
    };
    const auto damping = [](double value, const char* unit) {
        return Json{{"value", value}, {"unit", unit}};
    };
    for (const Edit& edit : {
             Edit{"3-analytic", "/critical_velocity/unit", "kg", "comparison",
                  ": the unit \"kg\" is not one of"},
             Edit{"3-analytic", "/critical_velocity/value", -2, "comparison",
                  ": is -2 m/s; allowed: 0 or more"},
             Edit{"3-analytic", "/critical_velocity/value", 1e300, "comparison",
                  ": is 1e+300 m/s; allowed: a"},
             Edit{"8-histories", "/hertz/0/damping", damping(1e300, "kg/s"), "comparison",
                  "/value: is 1e+300"},
             Edit{"7-critical-velocity", "/hertz/critical_velocity/value", 40, "comparison",
                  ": is 40 m/s, outside of its interval; allowed: upper end "},
             Edit{"6-fit", "/hertz/direct/critical_damping/value", 2.5, "critical-velocity",
                  ": is 2.5 kg/s, outside of its interval; allowed: upper end "},
             Edit{"6-fit", "/hertz/c/value", 2.5, "critical-velocity",
                  "/critical_damping: is not the c of the same fit; allowed: 2.5 kg/s, or edit c as well"},
             Edit{"6-fit", "/hertz/c/unit", "kg", "critical-velocity", ": the unit \"kg\" is not one of"},
             Edit{"6-fit", "/hertz/c", "a lot", "critical-velocity", ": "},
             Edit{"6-fit", "/hertz/a/value", 2.5, "critical-velocity", ": is not that of \"extrapolated\""},
             Edit{"6-fit", "/hertz/residual_deviation", damping(1e300, "kg/s"), "critical-velocity",
                  "/value: is 1e+300 kg/s"},
             Edit{"2-contact", "/density/value", 2500, "analytic",
                  "/mass: is not that of a sphere of this radius and density; allowed: "},
             Edit{"1-modulus", "/young_modulus/value", -1, "contact", ": is -1 Pa; allowed: 0 or more"},
             // Values that later stages do not read, or read elsewhere as well.
             Edit{"1-modulus", "/diameter/value", 80e-6, "contact",
                  "/result/samples/0/diameter/value: was edited, and only part of what comes after would "
                  "rest on "
                  "it; allowed: edits of young_modulus, density, poisson_ratio; or of 0-case.json, with "
                  "--from"},
             Edit{"1-modulus", "/phases/0/young_modulus/value", 80e9, "contact",
                  "/phases/0/young_modulus/value: was"},
             Edit{"2-contact", "/density_from_phases/value", 2500, "analytic",
                  "/density_from_phases/value: was"},
             Edit{"5-damping", "/hertz/velocity/values/3", 1.5, "fit",
                  "/hertz/velocity/values/3: was edited"},
             Edit{"5-damping", "/hertz/restitution/values/3", 0.5, "fit",
                  "or of 0-case.json, 2-contact.json, "
                  "4-restitution.json, with --from damping"},
             Edit{"5-damping", "/hertz/damping/values/3", 0.5, "fit", "/hertz/damping/values/3: was edited"},
             Edit{"6-fit", "/hertz/direct/critical_velocity/value", 1.0, "critical-velocity",
                  ": is 1 m/s, outside of its interval"},
             Edit{"7-critical-velocity", "/hertz/dissipated/value", 1e-7, "histories",
                  "/dissipated/value: was"},
             // Computed from another version of an edited artifact.
             Edit{"2-contact", "/work_of_adhesion/value", 0.2, "fit",
                  "one/3-analytic.json: was computed from another 2-contact.json than the one beside it; "
                  "allowed: --from analytic"},
         }) {
        const std::string file = std::string("one/") + edit.file + ".json";
        CAPTURE(file);
        CAPTURE(edit.pointer);
        const std::string bytes = sandbox.read(file);
        Json artifact = Json::parse(bytes);
        artifact["result"]["samples"][0][Json::json_pointer(edit.pointer)] = edit.value;
        sandbox.write(file, artifact.dump());
        check_refused(sandbox, std::string("run -o one --from ") + edit.stage, edit.says);
        sandbox.write(file, bytes);
    }
}

TEST_CASE("solved dampings of measured impacts are not edited: the fit is in the plane of both velocities") {
    const Sandbox sandbox;
    Json document = quick_case();
    document["laws"] = {"maugis-dugdale"};
    document["particle"]["tabor"] = 2;
    document["work_of_adhesion"] = "0.3 J/m2";
    run_case(sandbox, document, "one");
    Json artifact = sandbox.json("one/5-damping.json");
    artifact["result"]["samples"][0]["maugis-dugdale"]["damping"]["values"][1] = 0.5;
    sandbox.write("one/5-damping.json", artifact.dump());
    check_refused(sandbox, "run -o one --from fit", "/maugis-dugdale/damping/values/1: was edited");
}

TEST_CASE("an interval edited or removed with its value is taken; a density with its mass") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    const auto run_from = [&](const char* file, const std::function<void(Json&)>& edit, const char* stage) {
        Json artifact = sandbox.json(file);
        edit(artifact["result"]["samples"][0]);
        sandbox.write(file, artifact.dump());
        test::succeeded(sandbox, std::string("run -o one --from ") + stage);
    };
    run_from(
        "one/7-critical-velocity.json",
        [](Json& sample) {
            sample["hertz"]["critical_velocity"]["value"] = 40;
            sample["hertz"]["critical_velocity"].erase("interval");
            sample["hertz"].erase("interval");
            sample["hertz"].erase("check");
        },
        "histories");
    CHECK(sandbox.json(
              "one/comparison.json")["result"]["samples"][0]["dynamic_critical_velocity"]["hertz"]["value"] ==
          40);
    double mass = 0;
    run_from(
        "one/2-contact.json",
        [&](Json& sample) {
            for (const char* key : {"density", "mass"})
                sample[key]["value"] = 1.5 * sample[key]["value"].get<double>();
            mass = sample["mass"]["value"];
        },
        "analytic");
    const Json analytic = sandbox.json("one/3-analytic.json")["result"]["samples"][0];
    const double energy = analytic["separation_energy"]["value"];
    CHECK(analytic["critical_velocity"]["value"].get<double>() ==
          doctest::Approx(std::sqrt(2 * energy / mass)).epsilon(1e-4));
}

TEST_CASE("artifacts and cases of another schema version are refused by version") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    const Json whole = sandbox.json("one/3-analytic.json");
    Json artifact = whole;
    artifact.erase("schema_version");
    sandbox.write("one/3-analytic.json", artifact.dump());
    check_refused(sandbox, "run -o one --only comparison",
                  "\"schema_version\" is missing: an artifact of an earlier");
    artifact["schema_version"] = 2;
    sandbox.write("one/3-analytic.json", artifact.dump());
    check_refused(sandbox, "run -o one --only comparison", "/schema_version: is 2; allowed: 1");
    check_refused(sandbox, "inspect one/3-analytic.json", "/schema_version: is 2; allowed: 1");
    Json document = quick_case();
    document["schema_version"] = 7;
    sandbox.write("case.json", document.dump());
    check_refused(sandbox, "run case.json -o two", "case.json: /schema_version: is 7; allowed: 1");
    document["schema_version"] = 1;
    sandbox.write("case.json", document.dump());
    CHECK(ashimpact_program(sandbox, "run case.json -o two").status == 0);
}

TEST_CASE("where the damping is held, the uncertainty of the porosity is in the interval of v_c") {
    const Sandbox sandbox;
    const auto width = [&](const char* porosity) {
        Json document = quick_case();
        document["uncertainty"] = {{"damping", "held"}};
        document["samples"][0]["density"] = "2300 kg/m3";
        document["samples"][0]["porosity"] = {{"law", "pabst-gregorova"}, {"value", porosity}};
        std::filesystem::remove_all(sandbox.folder() / "held");
        run_case(sandbox, document, "held");
        const Json law = sandbox.json("held/7-critical-velocity.json")["result"]["samples"][0]["hertz"];
        return law["interval"]["upper"]["value"].get<double>() -
               law["interval"]["lower"]["value"].get<double>();
    };
    CHECK(width("15 +- 5 %") > 1.1 * width("15 %"));
}

TEST_CASE("impossible numbers of a case, a NUL in a name and endless lists are refused with their place") {
    const Sandbox sandbox;
    const auto refused = [&](const char* pointer, const Json& value, const std::string& says) {
        Json document = quick_case();
        document[Json::json_pointer(pointer)] = value;
        test::write_example(sandbox, document);
        check_refused(sandbox, "run case.json -o out", says);
    };
    refused("/wall/poisson_ratio", {{"value", 0.3}, {"unit", "1"}, {"standard_uncertainty", 1e30}},
            "case.json: /wall/poisson_ratio/standard_uncertainty: a standard uncertainty of 1e+30; allowed: "
            "0 to 1");
    refused("/samples/0/density", {{"value", 2500}, {"unit", "kg/m3"}, {"standard_uncertainty", 1e308}},
            "case.json: /samples/0/density/standard_uncertainty: a standard uncertainty of 1e+308");
    refused(
        "/samples/0/density", {{"value", 2500}, {"unit", "kg/m3"}, {"standard_uncertainty", 1e6}},
        "case.json: /samples/0/density/standard_uncertainty: is 1e+06; allowed: ten times the value at most");
    refused("/temperature", "900 +- 50 C",
            "case.json: /temperature: states an uncertainty, which nothing here uses");
    refused("/work_of_adhesion",
            {{"surface_energies", {{"particle", "40 +- 4 mJ/m2"}, {"wall", "0.5 J/m2"}}}, {"rule", "dupre"}},
            "case.json: /work_of_adhesion/surface_energies/particle: states an uncertainty, which nothing "
            "here uses");
    refused("/paper_explicit", {{"time_step", "1 +- 0.1 ns"}},
            "case.json: /paper_explicit/time_step: states an uncertainty, which nothing here uses");
    refused("/samples/0/diameter", "88 pm",
            "case.json: /samples/0/diameter: the diameter 88 pm is that of a molecule");
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
    check_refused(sandbox, "run inside/case.json -o out",
                  "impacts.csv: lies outside of the folder of the case");
    CHECK(ashimpact_program(sandbox, "run inside/case.json -o allowed --allow-outside").status == 0);
    for (const std::string command : {"calibrate", "cross-check"}) {
        check_refused(sandbox, command + " inside/case.json",
                      "impacts.csv: lies outside of the folder of the case");
        const auto allowed = ashimpact_program(sandbox, command + " inside/case.json --allow-outside");
        CHECK(allowed.err != containing("outside"));
    }
    std::filesystem::create_symlink("../impacts.csv", sandbox.folder() / "inside/link.csv");
    document["samples"][0]["restitution"]["file"] = "link.csv";
    sandbox.write("inside/case.json", document.dump());
    check_refused(sandbox, "run inside/case.json -o out", "link.csv: lies outside of the folder of the case");
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
    CHECK(sandbox.read("err") == containing("warning: standard output: cannot be written"));
    CHECK(sandbox.has("out/comparison.json"));
}

TEST_CASE("reports side by side list what was edited, to the last value of a list; exports state it") {
    const Sandbox sandbox;
    put_quick_run(sandbox);
    const auto differences = [&](const char* other) {
        test::succeeded(sandbox, std::string("report one ") + other + " -o both.html");
        const std::string page = sandbox.read("both.html");
        const auto from = page.find("<h2 id=\"differences\">");
        REQUIRE(from != std::string::npos);
        return page.substr(from, page.find("</section>", from) - from);
    };
    std::filesystem::copy(sandbox.path("one"), sandbox.path("two"));
    CHECK(differences("two") == containing("the runs have the same inputs"));
    Json artifact = sandbox.json("two/2-contact.json");
    Json& modulus = artifact["result"]["samples"][0]["contact_modulus"]["value"];
    modulus = 1.1 * modulus.get<double>();
    sandbox.write("two/2-contact.json", artifact.dump());
    test::succeeded(sandbox, "run -o two --from analytic");
    CHECK(differences("two") != containing("the runs have the same inputs"));
    CHECK(differences("two") == containing("2-contact.json, samples, fine, contact_modulus"));

    test::succeeded(sandbox, "export table two -o exported");
    CHECK(sandbox.read("exported/assumptions.md") ==
          containing("- 2-contact.json was edited after ashimpact wrote it"));
    CHECK(sandbox.json("exported/expected.json")["edited"] ==
          Json{"2-contact.json was edited after ashimpact wrote it"});
    test::succeeded(sandbox, "export table one -o plain");
    CHECK_FALSE(sandbox.json("plain/expected.json").contains("edited"));
    CHECK(sandbox.read("plain/assumptions.md") != containing("edited"));

    Json impacts = sandbox.json("one/0-case.json")["result"];
    Json& rebounds = impacts["samples"][0]["restitution"]["rebound_velocity"]["values"];
    rebounds.back() = 0.99 * rebounds.back().get<double>();
    artifact = sandbox.json("one/0-case.json");
    artifact["result"] = impacts;
    std::filesystem::copy(sandbox.path("one"), sandbox.path("three"));
    sandbox.write("three/0-case.json", artifact.dump());
    test::succeeded(sandbox, "run -o three --from modulus");
    CHECK(differences("three") == containing("samples, fine, restitution, rebound_velocity, values"));
}
