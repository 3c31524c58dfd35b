// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/spec.hpp"

#include <functional>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/pipeline/sweep/specs.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::full_spec;
using test::least_spec;

namespace {

std::string refusal(const Json& spec) {
    return test::input_error_of([&] { return read_sweep_spec(spec.dump()); });
}

/// A way to spoil a spec, and what has to be said of it.
struct Spoiled {
    const char* what;
    std::function<void(Json&)> spoil;
    const char* says;
};

const auto velocity_in = [](Json& spec) -> Json& { return spec["variables"]["velocity"]; };

const Spoiled spoiled_specs[]{
    {"missing part", [](Json& s) { s.erase("sampling"); }, "\"sampling\" is missing"},
    {"unknown key", [](Json& s) { s["sensitivty"] = {"restitution"}; },
     "/sensitivty: unknown key, did you mean \"sensitivity\"?"},
    {"no law", [](Json& s) { s["impact"]["laws"] = Json::array(); }, "/impact/laws: is a list of 0"},
    {"unknown law", [](Json& s) { s["impact"]["laws"] = {"dmtt"}; },
     "/impact/laws/0: unknown name \"dmtt\", did you mean \"dmt\"?"},
    {"law without data", [](Json& s) { s["impact"]["laws"] = {"thornton-ning"}; },
     "/impact: \"yield_pressure\" is missing"},
    {"law without its parameter", [](Json& s) { s["impact"]["laws"] = {"sjkr"}; },
     "/impact: cohesion_energy_density is missing, here or in /variables, for law \"sjkr\"; allowed: k_c"},
    {"negative parameter",
     [](Json& s) {
         s["impact"]["laws"] = {"sjkr"};
         s["impact"]["cohesion_energy_density"] = "-1 J/m3";
     },
     "/impact/cohesion_energy_density: cohesion_energy_density is -1 Pa"},
    {"detachment that is refused",
     [](Json& s) {
         s["impact"]["detachments"] = {{"dmt", "pull-off"}};
     },
     "/impact/detachments/dmt: "},
    {"detachment of a law that is not there",
     [](Json& s) {
         s["impact"]["detachments"] = {{"hertz", "zero-force"}};
     },
     "/impact/detachments/hertz: the law is not among"},
    {"no adhesion", [](Json& s) { s["impact"].erase("work_of_adhesion"); },
     "/impact: \"work_of_adhesion\" is missing"},
    {"no mass", [](Json& s) { s["impact"].erase("density"); },
     "/impact: \"density\" is missing, and so is \"mass\""},
    {"two masses", [](Json& s) { s["impact"]["mass"] = "1 ug"; }, "/impact: both \"density\" and \"mass\""},
    {"fixed and varied", [](Json& s) { s["impact"]["velocity"] = 1; },
     "/impact/velocity: varies too, in /variables"},
    {"wrong dimension", [](Json& s) { s["impact"]["density"] = "1 um"; },
     "/impact/density: the unit \"um\" is not one of density"},
    {"negative", [](Json& s) { s["impact"]["contact_modulus"] = -1; },
     "/impact/contact_modulus: contact_modulus is -1"},
    {"no variable", [](Json& s) { s["variables"] = Json::object(); }, "/variables: "},
    {"unknown variable", [](Json& s) { s["variables"]["radus"] = Json::object(); },
     "/variables/radus: unknown key, did you mean \"radius\"?"},
    {"no kind", [](Json& s) { velocity_in(s) = Json::object(); },
     "/variables/velocity: does not say in one way how it varies"},
    {"two kinds", [](Json& s) { velocity_in(s)["values"] = {1}; },
     "/variables/velocity: does not say in one way how it varies"},
    {"key of another kind", [](Json& s) { velocity_in(s)["mode"] = 1; },
     "/variables/velocity/mode: means nothing for \"uniform\""},
    {"parameter missing", [](Json& s) { velocity_in(s).erase("to"); },
     "/variables/velocity: \"to\" is missing"},
    {"parameters out of order", [](Json& s) { velocity_in(s)["to"] = 0.1; },
     "/variables/velocity: its numbers are not in order; allowed: from < to"},
    {"below zero", [](Json& s) { velocity_in(s)["from"] = -1; },
     "/variables/velocity: reaches down to -1 m/s"},
    {"normal below zero",
     [](Json& s) {
         velocity_in(s) = Json::parse(R"({"distribution": "normal", "mean": 2, "standard_deviation": 1})");
     },
     "/variables/velocity: a normal distribution reaches below zero; allowed: a \"minimum\" that is "
     "positive"},
    {"a value too small to compute with",
     [](Json& s) { velocity_in(s) = Json::parse(R"({"values": [1, 1e-50]})"); },
     "/variables/velocity: velocity is 1e-50 m/s; allowed: 1e-40 to 1e40"},
    {"a value too great that hardly ever comes",
     [](Json& s) { s["variables"]["radius"]["geometric_standard_deviation"] = 1e6; },
     "/variables/radius: radius is "},
    {"a spread too small to compute with",
     [](Json& s) {
         velocity_in(s) = Json::parse(
             R"({"distribution": "normal", "mean": 2, "standard_deviation": 5e-324, "minimum": 1})");
     },
     "/variables/velocity/standard_deviation: is 5e-324 m/s; allowed: 0, or 1e-40 to 1e40 in SI"},
    {"a beginning too small to compute with, though nothing is drawn there",
     [](Json& s) { velocity_in(s)["from"] = 5e-324; }, "/variables/velocity/from: is 5e-324 m/s"},
    {"an end too great to compute with", [](Json& s) { velocity_in(s)["to"] = 1e300; },
     "/variables/velocity/to: is 1e+300 m/s"},
    {"nothing left",
     [](Json& s) {
         velocity_in(s) =
             Json::parse(R"({"distribution": "normal", "mean": 2, "standard_deviation": 1, "minimum": 100})");
     },
     "/variables/velocity: minimum and maximum cut off all of it"},
    {"no spread", [](Json& s) { s["variables"]["radius"]["geometric_standard_deviation"] = 1; },
     "/variables/radius/geometric_standard_deviation: is 1"},
    {"a spread without meaning, though bounds cut it off",
     [](Json& s) {
         Json& radius = s["variables"]["radius"];
         radius["geometric_standard_deviation"] = 1e300;
         radius["minimum"] = "1 um";
         radius["maximum"] = "100 um";
     },
     "/variables/radius/geometric_standard_deviation: is 1e+300; allowed: a number above 1, at most 1e6"},
    {"grid of a distribution",
     [](Json& s) {
         s.erase("sensitivity");
         s["sampling"] = {{"method", "grid"}};
     },
     "/variables/velocity: a grid takes no distribution"},
    {"samples of a grid",
     [](Json& s) {
         s["sampling"] = {{"method", "grid"}, {"samples", 10}};
     },
     "/sampling/samples: means nothing for \"grid\""},
    {"no samples", [](Json& s) { s["sampling"].erase("samples"); }, "/sampling: \"samples\" is missing"},
    {"half a sample", [](Json& s) { s["sampling"]["samples"] = 10.5; },
     "/sampling/samples: is 10.5; allowed: a whole number"},
    {"negative seed", [](Json& s) { s["sampling"]["seed"] = -1; }, "/sampling/seed: is -1"},
    {"sequence of random points",
     [](Json& s) {
         s["sampling"]["method"] = "random";
         s["sampling"]["sequence"] = "sobol";
     },
     "/sampling/sequence: means nothing for \"random\""},
    {"shifts of random points",
     [](Json& s) {
         s["sampling"] = {{"method", "random"}, {"samples", 64}, {"seed", 1}, {"shifts", 4}};
     },
     "/sampling/shifts: means nothing for \"random\"; allowed: quasi-random sampling"},
    {"a list of ten thousand equal entries",
     [](Json& s) { s["table"] = std::vector<std::string>(10'000, "restitution"); },
     "/table: is a list of 10000 entries; allowed: at most 64"},
    {"fewer samples than shifts", [](Json& s) { s["sampling"]["samples"] = 8; },
     "/sampling: \"samples\" is "},
    {"unknown observable", [](Json& s) { s["table"] = {"restitusion"}; },
     "/table/0: unknown name \"restitusion\", did you mean \"restitution\"?"},
    {"sensitivity of what captures lack", [](Json& s) { s["sensitivity"] = {"contact_time"}; },
     "/sensitivity/0: a captured particle has none"},
    {"resolution of nothing", [](Json& s) { s["statistics"]["restitution"]["resolution"] = 0; },
     "/statistics/restitution/resolution: is 0"},
    {"resolution coarser than half of all",
     [](Json& s) { s["statistics"]["restitution"]["resolution"] = 0.501; },
     "/statistics/restitution/resolution: is 0.501; allowed: 1e-5 to 0.5"},
    {"quantile above one", [](Json& s) { s["statistics"]["restitution"]["quantiles"] = {1.5}; },
     "/statistics/restitution/quantiles/0: is 1.5; allowed: 0 to 1"},
};

}  // namespace

TEST_CASE("every way to spoil a spec is told in one line, with its place") {
    REQUIRE(refusal(full_spec(1000)).empty());
    for (const Spoiled& each : spoiled_specs) {
        CAPTURE(each.what);
        Json spec = full_spec(1000);
        each.spoil(spec);
        const std::string message = refusal(spec);
        CAPTURE(message);
        CHECK(message == test::containing(each.says));
        CHECK(message != test::containing("\n"));
    }
}

TEST_CASE("sensitivity of a grid is refused") {
    Json spec = least_spec();
    spec["sensitivity"] = {"restitution"};
    CHECK(refusal(spec) == test::containing("/sensitivity: needs points drawn at random"));
}

TEST_CASE("a wrong spec ends the program with status 2, one line and nothing written") {
    const test::Sandbox sandbox;
    Json spec = full_spec(1000);
    spec["variables"]["velocity"]["to"] = "5 kg";
    sandbox.write("spec.json", spec.dump());
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"},
          {ASHIMPACT_PROGRAM, "sweep", "missing.json", "-o", "out.json"},
          {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.h5"},
          {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "nowhere/out.json"},
          {ASHIMPACT_PROGRAM, "sweep", "spec.json"},
          {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json", "--threads", "-1"}}) {
        const test::Ended ended = test::run(sandbox, command);
        CAPTURE(ended.err);
        CHECK(ended.status == 2);
        CHECK(ended.out.empty());
        CHECK(test::lines_of(ended.err).size() == 1);
        CHECK(sandbox.everything().size() == 1);
    }
}

TEST_CASE("more rows than the disk has room for are refused before the first impact") {
    const test::Sandbox sandbox;
    Json spec = full_spec(1e15);
    spec["sampling"] = {{"method", "random"}, {"samples", 1e15}, {"seed", 1}};
    spec["table"] = {"restitution"};
    spec.erase("sensitivity");
    sandbox.write("spec.json", spec.dump());
    const test::Ended ended = test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"});
    CHECK(ended.status == 2);
    CHECK_MESSAGE(ended.err.find("out.h5: a table of 1000000000000000 rows takes ") == 0, ended.err);
    CHECK(sandbox.everything().size() == 1);
}

TEST_CASE("a wrong spec under mpirun has status 2 and is told once") {
    const test::Sandbox sandbox;
    Json spec = full_spec(1000);
    spec["variables"]["velocity"]["to"] = "5 kg";
    sandbox.write("spec.json", spec.dump());
    const test::Ended ended =
        test::run(sandbox, test::under_mpi(2, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"}));
    CHECK(ended.status == 2);
    const std::string place = "spec.json: /variables/velocity/to: ";
    CHECK(ended.err == test::containing(place));
    CHECK(ended.err.find(place) == ended.err.rfind(place));
    CHECK(sandbox.everything().size() == 1);
}

TEST_CASE("comments and layout are no part of what tells specs apart; values are") {
    const LoadedSpec plain = read_sweep_spec(full_spec(1000).dump());
    Json commented = full_spec(1000);
    commented["// why"] = "a comment";
    CHECK(read_sweep_spec(commented.dump(4)).canonical == plain.canonical);
    CHECK(read_sweep_spec(full_spec(1001).dump()).canonical != plain.canonical);
}

TEST_CASE("the forms of a variable") {
    Json json = least_spec();
    json["variables"] = Json::parse(R"({
        "velocity": {"grid": "linear", "from": "100 cm/s", "to": "3 m/s", "points": 3},
        "damping": {"values": ["1 g/s", {"value": 2, "unit": "g/s"}, 0]},
        "contact_modulus": {"values": [90, 91], "unit": "GPa"}})");
    json["impact"].erase("contact_modulus");
    const SweepSpec spec = read_sweep_spec(json.dump()).spec;
    CHECK(std::get<Choice>(spec.variables[0].distribution).values == std::vector<double>{1, 2, 3});
    CHECK(std::get<Choice>(spec.variables[1].distribution).values == std::vector<double>{1e-3, 2e-3, 0});
    CHECK(std::get<Choice>(spec.variables[2].distribution).values == std::vector<double>{90e9, 91e9});
}

TEST_CASE("an input that no law uses is said, not refused") {
    Json json = least_spec();
    json["impact"]["work_of_adhesion"] = "0.3 J/m2";
    const SweepSpec spec = read_sweep_spec(json.dump()).spec;
    REQUIRE(spec.warnings.size() == 1);
    CHECK(spec.warnings[0] == test::containing("work_of_adhesion changes nothing"));
}

TEST_CASE("every parameter of a law is an input of its own, by its name") {
    REQUIRE(law_parameters().size() > 1);
    for (const LawParameter& parameter : law_parameters()) {
        CAPTURE(parameter.name);
        CHECK(name_of(input_of(parameter)) == parameter.name);
    }
}
