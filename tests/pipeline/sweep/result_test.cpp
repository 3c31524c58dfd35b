// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "core/json/document.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/pipeline/sweep/specs.hpp"

using namespace ashimpact;

namespace {

Json artifact_of(const Json& spec, const ImpactSolver& solver) {
    const SweepPlan plan(spec.dump());
    SweepProgress progress;
    while (progress.chunks < plan.chunks()) {
        const Block block{progress.chunks, 0};
        progress.add(block, compute_block(plan, solver, block));
    }
    Json artifact = sweep_artifact(plan, progress, {"spec.json", std::string(64, '0')});
    CHECK_NOTHROW(validate_document(Json::parse(write_json(artifact)), "sweep-result"));
    return artifact;
}

/// Ishigami's function, put between 0 and 1, of inputs uniform on [1, 2] in the unit of each.
ResultColumns ishigami(const ImpactModel&, const ImpactColumns& impacts, const WantedResults&) {
    const auto angle = [](double value) { return 2 * std::numbers::pi * (value - 1.5); };
    ResultColumns results;
    for (std::size_t i = 0; i < impacts.velocity.size(); ++i) {
        const double x1 = std::sin(angle(impacts.velocity[i]));
        const double x2 = std::sin(angle(value_at(impacts.damping, i)));
        const double f =
            x1 + 7 * x2 * x2 + 0.1 * std::pow(angle(value_at(impacts.contact_modulus, i)), 4) * x1;
        results.restitution.push_back((f + 12) / 32);
    }
    return results;
}

double value(const Json& quantity) {
    return quantity.at("value").get<double>();
}

}  // namespace

TEST_CASE("a sweep finds the known Sobol indices of the Ishigami function, with honest errors") {
    for (const char* method : {"random", "quasi-random"}) {
        CAPTURE(method);
        const Json spec{
            {"impact", {{"laws", {"hertz"}}, {"mass", 1e-9}, {"radius", 44e-6}}},
            {"variables",
             {{"velocity", {{"distribution", "uniform"}, {"from", 1}, {"to", 2}}},
              {"damping", {{"distribution", "uniform"}, {"from", 1}, {"to", 2}}},
              {"contact_modulus", {{"distribution", "uniform"}, {"from", "1 Pa"}, {"to", "2 Pa"}}}}},
            {"sampling", {{"method", method}, {"samples", 1 << 16}, {"seed", 11}}},
            {"sensitivity", {"restitution"}}};
        const Json artifact = artifact_of(spec, ishigami);
        CHECK(artifact["result"]["laws"][0]["method"] == "integration");
        const Json& indices = artifact["result"]["laws"][0]["sensitivity"][0]["indices"];
        const std::array<double, 3> first{0.3139, 0.4424, 0};
        const std::array<double, 3> total{0.5576, 0.4424, 0.2437};
        REQUIRE(indices.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            CAPTURE(i);
            for (const auto& [key, known] : {std::pair{"first", first[i]}, std::pair{"total", total[i]}}) {
                const double error = indices[i][key]["standard_uncertainty"].get<double>();
                CHECK(error < (std::string(method) == "random" ? 0.02 : 0.003));
                CHECK(std::abs(value(indices[i][key]) - known) < 5 * error + 1e-4);  // known to four digits
            }
        }
    }
}

TEST_CASE("moments, capture fraction and quantiles of a uniform restitution") {
    const auto uniform = [](const ImpactModel&, const ImpactColumns& impacts, const WantedResults&) {
        ResultColumns results;
        for (const double v : impacts.velocity) results.restitution.push_back(std::max(0.0, v - 1));
        return results;
    };
    for (const char* method : {"random", "quasi-random"}) {
        Json spec = test::least_spec();
        spec["variables"]["velocity"] = {{"distribution", "uniform"}, {"from", 0.75}, {"to", 1.75}};
        spec["sampling"] = {{"method", method}, {"samples", 100'000}};
        spec["statistics"] = {{"restitution", {{"resolution", 0.01}, {"quantiles", {0.1, 0.5, 1}}}}};
        const Json artifact = artifact_of(spec, uniform);
        const Json& law = artifact["result"]["laws"][0];
        const auto within_errors = [&](const Json& quantity, double known) {
            const double error = quantity["standard_uncertainty"].get<double>();
            CHECK(error > 0);
            CHECK(error < 0.002);
            CHECK(std::abs(value(quantity) - known) < 5 * error);
        };
        within_errors(law["capture_fraction"], 0.25);
        const Json& restitution = law["observables"][0];
        within_errors(restitution["mean"], 0.75 * 0.75 / 2);
        CHECK(value(restitution["minimum"]) == 0);
        CHECK(restitution["histogram"]["zeros"] == law["captured"]);
        CHECK(value(restitution["quantiles"][0]["upper"]) == 0);
        CHECK(value(restitution["quantiles"][1]["lower"]) <= 0.2501);
        CHECK(value(restitution["quantiles"][1]["upper"]) >= 0.2499);
        CHECK(value(restitution["quantiles"][2]["upper"]) == 0.75);
        CHECK(law["impacts"] == 100'000);
    }
}

TEST_CASE("copies that hold the same number of captures leave an error of one impact") {
    const auto half = [](const ImpactModel&, const ImpactColumns& impacts, const WantedResults&) {
        ResultColumns results;
        for (const double v : impacts.velocity) results.restitution.push_back(v < 1 ? 0.0 : 0.5);
        return results;
    };
    Json spec = test::least_spec();
    spec["variables"]["velocity"] = {{"distribution", "uniform"}, {"from", 0.5}, {"to", 1.5}};
    spec["sampling"] = {{"method", "quasi-random"}, {"samples", 1 << 10}};
    const Json law = artifact_of(spec, half)["result"]["laws"][0];
    CHECK(law["captured"] == 1 << 9);
    CHECK(law["capture_fraction"]["standard_uncertainty"] == 1.0 / (1 << 10));
}

TEST_CASE("what there is nothing of is null") {
    const auto captured = [](const ImpactModel&, const ImpactColumns& impacts, const WantedResults&) {
        const std::vector<double> none(impacts.velocity.size(), std::nan(""));
        return ResultColumns{std::vector<double>(impacts.velocity.size(), 0.0), none, {}};
    };
    Json spec = test::least_spec();
    spec["statistics"] = {{"restitution", Json::object()}, {"contact_time", Json::object()}};
    const Json artifact = artifact_of(spec, captured);
    const Json& law = artifact["result"]["laws"][0];
    CHECK(law["captured"] == 2);
    CHECK_FALSE(law["capture_fraction"].contains("standard_uncertainty"));
    const Json& time = law["observables"][1];
    CHECK(time["count"] == 0);
    for (const char* key : {"mean", "standard_deviation", "skewness", "minimum"}) CHECK(time[key].is_null());
    CHECK(time["quantiles"].empty());
}

TEST_CASE("the program's own artifact is what its schema says, and inspect shows it") {
    const test::Sandbox sandbox;
    sandbox.write("spec.json", test::full_spec(3'000).dump());
    REQUIRE(test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"}).status == 0);
    CHECK_NOTHROW(validate_document(sandbox.json("out.json"), "sweep-result"));
    const test::Ended inspected = test::run(sandbox, {ASHIMPACT_PROGRAM, "inspect", "out.json"});
    CHECK(inspected.status == 0);
    CHECK(inspected.out == test::containing("sensitivity"));
    CHECK(inspected.err != test::containing("edited"));
    Json edited = sandbox.json("out.json");
    edited["result"]["laws"][0]["captured"] = 1;
    sandbox.write("out.json", edited.dump());
    for (const char* command : {"inspect", "report"}) {
        const test::Ended shown = test::run(sandbox, {ASHIMPACT_PROGRAM, command, "out.json"});
        CHECK(shown.status == 0);
        CHECK(shown.err == test::containing("out.json: was edited after ashimpact wrote it"));
    }
    CHECK(sandbox.read("out.html") == test::containing("was edited after ashimpact wrote it"));
    edited["provenance"].erase("result_sha256");  // as of older versions
    sandbox.write("out.json", edited.dump());
    CHECK(test::run(sandbox, {ASHIMPACT_PROGRAM, "inspect", "out.json"}).err != test::containing("edited"));
}

TEST_CASE("the example of the help text is a sweep that runs") {
    const test::Sandbox sandbox;
    const std::string help = test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "--help"}).out;
    const auto begin = help.find("  {\n");
    const auto end = help.find("\n  }\n");
    REQUIRE(begin != std::string::npos);
    REQUIRE(end != std::string::npos);
    sandbox.write("spec.json", help.substr(begin, end + 4 - begin));
    const test::Ended ended =
        test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "sweep.json"});
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
}

TEST_CASE("the examples of docs/sweep.md are sweeps that run") {
    const std::string page = read_file(ASHIMPACT_DOCS "/sweep.md");
    const std::string fence = "```json\n";
    int examples = 0;
    for (auto at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
        const auto begin = at + fence.size();
        const test::Sandbox sandbox;
        sandbox.write("spec.json", page.substr(begin, page.find("```", begin) - begin));
        const test::Ended ended =
            test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "sweep.json"});
        CAPTURE(ended.err);
        CHECK(ended.status == 0);
        ++examples;
    }
    CHECK(examples == 2);
}

namespace ashimpact {

namespace {

using report::CaptureShare;

/// Impacts whose velocities are far below and far above any critical velocity.
SweepSpec slow_and_fast() {
    return read_sweep_spec(R"({
        "impact": {"laws": ["jkr"], "density": "2300 kg/m3", "contact_modulus": "90 GPa",
                   "work_of_adhesion": "0.3 J/m2", "damping": "0.001 kg/s"},
        "variables": {
            "velocity": {"values": ["1 mm/s", "500 m/s"]},
            "radius": {"grid": "linear", "from": "20 um", "to": "60 um", "points": 40}},
        "sampling": {"method": "grid"}})")
        .spec;
}

}  // namespace

TEST_CASE("capture against a variable of few values: all of the slow impacts, none of the fast") {
    const auto variables = capture_fractions(slow_and_fast()).variables;
    REQUIRE(variables.size() == 2);
    const std::vector<CaptureShare>& velocity = variables[0].curves[0].shares;
    REQUIRE(velocity.size() == 2);
    CHECK(velocity[0].value == 1e-3);
    CHECK(velocity[0].fraction == 1.0);
    CHECK(velocity[1].value == 500.0);
    CHECK(velocity[1].fraction == 0.0);
    // Of 40 impacts without an exception: as if half an impact might be one.
    for (const CaptureShare& share : velocity)
        CHECK(share.standard_uncertainty == doctest::Approx(0.5 / 40).epsilon(1e-14));
}

TEST_CASE("capture against a variable of many values, in sixteen parts of equally many impacts") {
    const auto variables = capture_fractions(slow_and_fast()).variables;
    const std::vector<CaptureShare>& radius = variables[1].curves[0].shares;
    REQUIRE(radius.size() == 16);
    for (std::size_t i = 0; i < radius.size(); ++i) {
        CAPTURE(i);
        if (i > 0) CHECK(radius[i].value > radius[i - 1].value);
        // Of five impacts two or three are slow, as their radius is listed twice.
        CHECK(std::abs(radius[i].fraction - 0.5) < 0.11);
        CHECK(radius[i].standard_uncertainty ==
              doctest::Approx(std::sqrt(radius[i].fraction * (1 - radius[i].fraction) / 5)).epsilon(1e-14));
    }
}

}  // namespace ashimpact

TEST_CASE("many impacts come from tables, where the law and the damping law have one") {
    const auto method = [](double samples, const Json& impact) {
        Json spec = test::full_spec(samples);
        spec["impact"].update(impact);
        return name_of(SweepPlan(spec.dump()).wanted(Law::named("dmt")).method);
    };
    const Json two_terms{
        {"damping_law", "brach-dunn-damping"}, {"damping", 0.2}, {"adhesion_damping_ratio", 1}};
    CHECK(method(1 << 10, Json::object()) == "integration");
    CHECK(method(1 << 19, Json::object()) == "table");
    CHECK(method(1 << 19, two_terms) == "integration");
}
