// SPDX-License-Identifier: GPL-3.0-or-later
// Which velocity a run reports, by which law, and what it leaves open.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "core/embedded.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/run/comparison/reported_velocity.hpp"
#include "pipeline/run/reported_law.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/regime.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::computed_from;
using test::relative_difference;

namespace {

/// A sphere of fly ash on steel. @param w work of adhesion [J/m2]
ContactPair ash_contact(double radius, double w) {
    return {.mass = 2300.0 * 4 / 3 * std::numbers::pi * radius * radius * radius,
            .effective_radius = radius,
            .contact_modulus = 90e9,
            .work_of_adhesion = w};
}

/// The law that is reported of contacts, and those that are admissible.
std::optional<ReportedLaw> reported_of(const std::vector<const char*>& laws,
                                       const std::vector<ContactPair>& pairs,
                                       const std::vector<double>& rebounds = {}) {
    Case data{.name = "case"};
    for (const char* law : laws) data.laws.push_back({Law::named(law), Law::named(law).default_detachment()});
    ContactResult contacts;
    for (const ContactPair& pair : pairs) {
        Sample sample{.name = "sample", .diameter = {}};
        MeasuredRestitution measured;
        measured.impacts.points.push_back({.velocity = 0.01, .rebound = 0});  // a capture
        for (const double velocity : rebounds)
            measured.impacts.points.push_back({.velocity = velocity, .rebound = 0.3 * velocity});
        sample.restitution = measured;
        data.samples.push_back(sample);
        contacts.samples.push_back({.name = "sample", .pair = pair});
    }
    return reported_law(data, contacts);
}

std::vector<std::string> names(const std::vector<Law>& laws) {
    std::vector<std::string> words;
    for (const Law law : laws) words.emplace_back(law.name());
    return words;
}

const std::vector<const char*> five_laws{"hertz", "dmt", "brach-dunn", "jkr", "maugis-dugdale"};
const std::vector<const char*> four_laws{"hertz", "dmt", "brach-dunn", "jkr"};

Json built_in_document() {
    return parse_json(embedded_file("cases/dong2013/case.json").value());
}

const Run& reproduced_run() {
    static const Run run = read_run(compute_artifacts(std::nullopt, "comparison"));
    return run;
}

/// Whether a member is the measured velocity of the case or a result computed from it.
bool is_of_measured_velocity(const std::string& pointer) {
    for (const char* own : {"/check", "/measured", "/joint_tests"})
        if (pointer.find(own) != std::string::npos) return true;
    return false;
}

/// Members of the results of a run that differ without the measured velocities, other than those themselves.
std::vector<std::string> differences_without_measured(const Json& document) {
    Json without = document;
    for (Json& sample : without["samples"]) sample.erase("measured_critical_velocity");
    const Artifacts with = computed_from(document);
    const Artifacts blind = computed_from(without);
    std::vector<std::string> pointers;
    for (const Stage& stage : stages()) {
        const Json one = with.at(stage.file).document->at("result").flatten();
        const Json other = blind.at(stage.file).document->at("result").flatten();
        for (const auto* pair : {&one, &other})
            for (const auto& [pointer, value] : pair->items())
                if (one.value(pointer, Json("absent")) != other.value(pointer, Json("absent")) &&
                    !is_of_measured_velocity(pointer))
                    pointers.push_back(std::string(stage.file) + pointer);
    }
    return pointers;
}

}  // namespace

TEST_CASE("one law for all samples, by Tabor parameter and yield, with the laws that these admit") {
    struct Chosen {
        std::vector<const char*> laws;
        std::vector<double> adhesion;  ///< of each sample [J/m2]
        std::string law;
        std::vector<std::string> admissible;
    };
    const double between = 0.3;  // J/m2, Tabor parameter 2
    const double hard = 1e-3;    // 0.04
    const double soft = 3;       // 9
    CHECK(tabor_parameter_of(ash_contact(44e-6, between)) == doctest::Approx(2.0).epsilon(0.02));
    const std::vector<Chosen> cases{
        {five_laws, {between}, "maugis-dugdale", {"dmt", "jkr", "maugis-dugdale"}},
        {five_laws, {hard}, "maugis-dugdale", {"dmt", "maugis-dugdale"}},
        {five_laws, {soft}, "maugis-dugdale", {"jkr", "maugis-dugdale"}},
        {four_laws, {between}, "jkr", {"dmt", "jkr"}},
        {four_laws, {hard}, "dmt", {"dmt"}},
        {four_laws, {soft}, "jkr", {"jkr"}},
        {four_laws, {hard, hard, between}, "dmt", {"dmt", "jkr"}},
        {four_laws, {hard, soft, between}, "jkr", {"dmt", "jkr"}},
        {{"hertz", "brach-dunn"}, {between}, "brach-dunn", {"brach-dunn"}},
        {{"hertz"}, {between}, "hertz", {"hertz"}},
        {four_laws, {0}, "hertz", {"hertz"}},
    };
    for (const Chosen& chosen : cases) {
        std::vector<ContactPair> pairs;
        for (const double w : chosen.adhesion) pairs.push_back(ash_contact(44e-6, w));
        const auto reported = reported_of(chosen.laws, pairs);
        REQUIRE(reported);
        CAPTURE(chosen.law);
        CAPTURE(chosen.adhesion.front());
        CHECK(reported->law.name() == chosen.law);
        CHECK(names(reported->admissible) == chosen.admissible);
    }
    CHECK_FALSE(reported_of({}, {ash_contact(44e-6, 0.3)}));
}

TEST_CASE("a contact that yields in every rebound is reported by a law that includes it") {
    ContactPair soft_wall = ash_contact(44e-6, 0.3);
    soft_wall.yield_pressure = 3e9;
    const double yields = yield_velocity(soft_wall);
    std::vector<const char*> laws = five_laws;
    laws.insert(laws.begin() + 4, "thornton-ning");
    const auto fast = reported_of(laws, {ash_contact(44e-6, 0.3), soft_wall}, {2 * yields, 4 * yields});
    CHECK(fast->law.name() == "thornton-ning");
    CHECK(names(fast->admissible) == std::vector<std::string>{"thornton-ning"});
    const auto slow = reported_of(laws, {soft_wall}, {0.3 * yields, 4 * yields});
    CHECK(slow->law.name() == "maugis-dugdale");
    CHECK(names(slow->admissible) == std::vector<std::string>{"dmt", "jkr", "maugis-dugdale"});
}

TEST_CASE("the measured critical velocity of a case changes no number but its own") {
    CHECK(differences_without_measured(built_in_document()) == std::vector<std::string>{});
    if (!test::sanitized)
        CHECK(differences_without_measured(test::example_case()) == std::vector<std::string>{});
}

TEST_CASE("a run of measured impacts reports one velocity, whatever the law" *
          doctest::skip(test::sanitized)) {
    const Artifacts artifacts = computed_from(test::example_case());
    const Json& result = artifacts.at("comparison.json").document->at("result");
    const Json& reported = result["reported"];
    CHECK(reported["law"] == "maugis-dugdale");
    CHECK(reported["admissible"] == Json{"dmt", "jkr", "maugis-dugdale"});
    REQUIRE(reported["samples"].size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const Json& sample = result["samples"][i];
        const Json& row = reported["samples"][i];
        CHECK(row["name"] == sample["name"]);
        CHECK(row["basis"] == "measured impacts");
        CHECK(row["interval"] == sample["reported"]["interval"]);
        CHECK(row["critical_velocity"]["value"] ==
              sample["dynamic_critical_velocity"]["maugis-dugdale"]["value"]);
        CHECK(relative_difference(row["interval"]["lower"]["value"].get<double>(),
                                  sample["interval"]["hertz"]["lower"]["value"].get<double>()) < 1e-4);
    }
}

TEST_CASE("maugis-dugdale takes the estimate of jkr: measured is the curve, which ends at v_c") {
    constexpr double map_error = 1e-5;  // of the map through which jkr is estimated
    const Json document = test::with_one_sample(test::example_case(), {"jkr", "maugis-dugdale"});
    const Run run = read_run(computed_from(document));
    const auto& velocities = run.critical_velocity.samples[0].laws;
    const VelocityEstimate& jkr = velocities.find(Law::named("jkr"))->velocity.value();
    const LawCriticalVelocity& own = *velocities.find(Law::named("maugis-dugdale"));
    CHECK(own.velocity->method == VelocityMethod::estimate);
    CHECK(relative_difference(own.velocity->value, jkr.value) < map_error);
    CHECK(relative_difference(*own.velocity->interval->lower, *jkr.interval->lower) < map_error);
    CHECK(relative_difference(*own.velocity->interval->upper, *jkr.interval->upper) < map_error);
    const LawFit& fit = *run.fit.samples[0].laws.find(Law::named("maugis-dugdale"));
    CHECK(fit.critical_damping != run.fit.samples[0].laws.find(Law::named("jkr"))->critical_damping);
    const auto again = critical_velocity({Law::named("maugis-dugdale"),
                                          own.detachment,
                                          {DampingLaw::constant, fit.critical_damping},
                                          run.contact.samples[0].pair});
    CHECK(relative_difference(again.value.value(), jkr.value) < map_error);
    REQUIRE(fit.estimate->curve);
    CHECK(std::ranges::is_sorted(fit.estimate->curve->velocity));
    CHECK(fit.estimate->curve->velocity.size() >= 8);
}

TEST_CASE("a law that cannot be fitted to a sample is replaced there, a capture at every velocity is not") {
    const ReportedLaw law{Law::named("jkr"), "why", {Law::named("jkr")}};
    const std::vector<Law> preference{Law::named("jkr"), Law::named("dmt")};
    LawMap<LawCriticalVelocity> velocities;
    velocities.set(Law::named("dmt"),
                   {.velocity = VelocityEstimate{.value = 0.5, .interval = Bounds{0.4, 0.6}}});
    std::optional<MeasuredCriticalVelocity> known(std::in_place);
    known->lower = 0.3;
    known->note = "captures only";
    const std::string none = "no impacts were given";
    const auto reported = [&] {
        return reported_velocity({law, preference, velocities, known, ReportedBasis::impacts, none});
    };
    const ReportedVelocity replaced = reported();
    CHECK(replaced.law->name() == "dmt");
    CHECK(replaced.velocity->value == 0.5);
    CHECK(replaced.reason == "jkr, by which the run reports, could not be fitted here");
    const ReportedLaw both{Law::named("dmt"), "why", {Law::named("dmt"), Law::named("jkr")}};
    for (const std::optional<double> lower : {std::optional(0.45), std::optional<double>()}) {
        LawMap<LawCriticalVelocity> two = velocities;
        two.set(Law::named("jkr"),
                {.velocity = VelocityEstimate{.value = 0.6, .interval = Bounds{lower, 0.7}}});
        const Bounds over =
            *reported_velocity({both, preference, two, known, ReportedBasis::impacts, none}).interval;
        CHECK(over.lower == (lower ? std::optional(0.4) : lower));
        CHECK(over.upper == 0.7);
    }
    velocities.set(Law::named("jkr"), {.verdict = CaptureVerdict::always_captured});
    const ReportedVelocity captured = reported();
    CHECK_FALSE(captured.law);
    CHECK_FALSE(captured.velocity);
    CHECK(captured.interval->lower == 0.3);
    CHECK(captured.basis == ReportedBasis::outcomes);
    CHECK(captured.reason == test::containing("no finite velocity by jkr: always-captured"));
}

TEST_CASE("a measured velocity without an uncertainty judges no law, one with it does") {
    Json document = test::with_one_sample(test::example_case(), {"jkr"});
    const auto verdict = [&] {
        const Artifacts artifacts = computed_from(document);
        const Json& measured =
            artifacts.at("7-critical-velocity.json").document->at("result")["samples"][0]["measured"];
        const Json& sample = artifacts.at("comparison.json").document->at("result")["samples"][0];
        CHECK(sample.contains("measured_interval") ==
              measured["critical_velocity"].contains("standard_uncertainty"));
        return sample["check"]["jkr"]["verdict"].get<std::string>() + ", " +
               measured["note"].get<std::string>();
    };
    CHECK(verdict() == "agrees, as reported in the case");
    document["samples"][0]["measured_critical_velocity"] = "5.00 m/s";
    CHECK(verdict() == "not-comparable, as reported in the case, without an uncertainty");
    document["samples"][0]["measured_critical_velocity"] = {
        {"value", 5}, {"unit", "m/s"}, {"standard_uncertainty", 0.1}};
    CHECK(verdict() == "model-too-low, as reported in the case");
}

TEST_CASE("a case without laws has maugis-dugdale with an assumed range, and thornton-ning where it yields") {
    Json document = test::example_case();
    document.erase("laws");
    document.erase("particle");
    const auto loaded = [&] {
        const test::Sandbox sandbox;
        test::write_example(sandbox, document);
        return load_case(sandbox.path("case.json")).data;
    };
    const auto laws_of = [](const Case& data) {
        std::vector<Law> laws;
        for (const LawChoice& choice : data.laws) laws.push_back(choice.law);
        return names(laws);
    };
    const Case plain = loaded();
    CHECK(laws_of(plain) == std::vector<std::string>{five_laws.begin(), five_laws.end()});
    for (const Sample& sample : plain.samples) {
        REQUIRE(sample.parameters.size() == 1);
        CHECK(sample.parameters[0].first.name == "cohesion_range");
        CHECK(sample.parameters[0].second.value() == usual_separation);
        CHECK(sample.parameters[0].second.origin == Origin::assumed);
    }
    document["samples"][1]["tabor"] = 1.5;
    document["samples"][1]["yield_pressure"] = "5 GPa";
    CHECK(laws_of(loaded()).size() == five_laws.size());
    document["laws"] = {"dmt", "thornton-ning"};
    CHECK(test::input_error_of(loaded) ==
          test::containing(
              "/laws/1: law thornton-ning needs a yield_pressure, which sample \"fine\" does not"));
    document.erase("laws");
    document["samples"][0]["yield_pressure"] = "6 GPa";
    const Case own = loaded();
    CHECK(laws_of(own)[4] == "thornton-ning");
    CHECK(own.samples[0].parameters[0].first.name == "cohesion_range");
    REQUIRE(own.samples[1].parameters.size() == 1);
    CHECK(own.samples[1].parameters[0].first.name == "tabor");
}

TEST_CASE("the paper's case is a reproduction: one law, no interval, and what it leaves open") {
    const ComparisonResult& result = reproduced_run().comparison;
    CHECK(result.reported->law.name() == "maugis-dugdale");
    REQUIRE(result.reproduction);
    REQUIRE(result.reproduction->samples.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const SampleComparison& sample = result.samples[i];
        const ReproducedSample& open = result.reproduction->samples[i];
        CHECK(sample.reported->law->name() == "maugis-dugdale");
        CHECK(sample.reported->basis == ReportedBasis::reproduction);
        CHECK_FALSE(sample.reported->interval);
        CHECK_FALSE(sample.reported->velocity->standard_uncertainty);
        const double own = sample.reported->velocity->value;
        REQUIRE(open.fits);
        for (const VelocitySpan& span : {open.laws, *open.fits, open.diameter}) {
            CHECK(span.least < own);
            CHECK(span.greatest > own);
        }
        CHECK(open.laws.greatest == sample.laws.find(Law::named("brach-dunn"))->velocity->value);
        // The diameter alone: E*, density, w and damping held.
        ContactPair smaller = reproduced_run().contact.samples[i].pair;
        const double ratio = (smaller.effective_radius - 0.5e-6) / smaller.effective_radius;
        smaller.effective_radius *= ratio;
        smaller.mass *= ratio * ratio * ratio;
        const LawCriticalVelocity& dynamic =
            *reproduced_run().critical_velocity.samples[i].laws.find(result.reported->law);
        CHECK(relative_difference(open.diameter.greatest,
                                  critical_velocity({result.reported->law,
                                                     dynamic.detachment,
                                                     {DampingLaw::constant, dynamic.damping},
                                                     smaller})
                                      .value.value()) < 1e-9);
    }
    // Squared deviations from 1.92, 1.25 and 0.69 m/s, which state no uncertainty.
    for (const auto& [law, sum] : std::vector<std::pair<const char*, double>>{
             {"brach-dunn", 19.8}, {"jkr", 15.2}, {"maugis-dugdale", 14.6}}) {
        const JointTest* test = result.reproduction->joint_tests.find(Law::named(law));
        REQUIRE(test != nullptr);
        CHECK(test->samples == 3);
        CHECK(test->sum_of_squares == doctest::Approx(sum).epsilon(0.01));
    }
}
