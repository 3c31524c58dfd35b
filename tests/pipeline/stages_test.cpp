// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/run/comparison/velocities.hpp"
#include "pipeline/run/stage.hpp"
#include "pipeline/run/uncertainty/calibration.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::computed_from;
using test::example_under;
using test::relative_difference;
using test::Sandbox;

namespace {

const Artifacts& built_in() {
    static const Artifacts artifacts = compute_artifacts(std::nullopt, "comparison");
    return artifacts;
}

const Artifacts& example() {
    static const Artifacts artifacts = computed_from(test::example_case());
    return artifacts;
}

const Run& built_in_run() {
    static const Run run = read_run(built_in());
    return run;
}

const Json& result(std::string_view file) {
    return built_in().at(file).document->at("result");
}

template <class Samples>
const auto& named(const Samples& samples, const std::string& name) {
    for (const auto& sample : samples)
        if (sample.name == name) return sample;
    throw std::logic_error("no such sample");
}

}  // namespace

TEST_CASE("every artifact of a run conforms to its schema and has the envelope") {
    for (const Artifacts& artifacts : {built_in(), example()}) {
        std::vector<std::string> files{std::string(case_artifact)};
        for (const Stage& stage : stages()) files.emplace_back(stage.file);
        for (const std::string& file : files) {
            const Json& document = *artifacts.at(file).document;
            CHECK_NOTHROW(validate_document(document, file.substr(0, file.size() - 5)));
            std::vector<std::string> keys;
            for (const auto& [key, _] : document.items()) keys.push_back(key);
            CHECK(keys == std::vector<std::string>{"schema", "schema_version", "stage", "provenance",
                                                   "citations", "warnings", "notes", "result"});
            CHECK(parse_json(artifacts.at(file).bytes) == document);
        }
    }
}

TEST_CASE("every artifact that follows from the case says where contacts end, and what was refused and why") {
    std::vector<std::string_view> files{case_artifact};
    for (const Stage& stage : stages())
        if (stage.name != "analytic") files.push_back(stage.file);
    for (const std::string_view file : files) {
        CAPTURE(file);
        const Json& ends = built_in().at(file).document->at("provenance")["options"]["detachments"];
        CHECK(ends["jkr"]["ends_at"] == "pull-off");
        CHECK(ends["dmt"]["ends_at"] == "zero-overlap");
        CHECK(ends["dmt"]["refused"]["zero-force"].get<std::string>().ends_with(
            "its potential there is below that at first touch, an undamped impact would gain energy"));
        CHECK(ends["jkr"]["refused"].size() == 1);
    }
    const Json& analytic = built_in().at("3-analytic.json").document->at("provenance").at("options");
    CHECK(analytic["separation"] == "pull-off");
}

TEST_CASE("results read back from artifacts are written again as they were, and say what was computed") {
    Json yielding = example_under("thornton-ning");
    for (Json& sample : yielding["samples"]) sample["yield_pressure"] = "5 GPa";
    for (const Artifacts& artifacts : {built_in(), example(), computed_from(yielding)}) {
        const Run run = read_run(artifacts);
        for (const Stage& stage : stages()) {
            const Artifact& artifact = artifacts.at(stage.file);
            CAPTURE(artifact.file);
            CHECK(result_json(run, stage.file).dump() == artifact.document->at("result").dump());
            const StageRecord* record = run.record(stage.file);
            REQUIRE(record != nullptr);
            REQUIRE(record->notes.size() == artifact.document->at("warnings").size());
            for (std::size_t i = 0; i < record->notes.size(); ++i)
                CHECK(text_of(record->notes[i]) == artifact.document->at("warnings")[i].get<std::string>());
        }
    }
}

TEST_CASE("2-contact: mass from density and diameter, origins kept") {
    for (const SampleContact& sample : built_in_run().contact.samples) {
        const double r = sample.pair.effective_radius;
        CHECK(relative_difference(sample.pair.mass, 4.0 / 3.0 * M_PI * r * r * r * sample.density.value()) <
              1e-14);
    }
    CHECK(result("2-contact.json")["samples"][0]["work_of_adhesion"]["origin"] == "inferred");
}

TEST_CASE("2-contact: Eq. 7 with an elastic wall, a rigid one, and a modulus that is given") {
    Json document = test::example_case();
    const auto modulus_of = [&] {
        const Artifacts artifacts = computed_from(document, "contact");
        return artifacts.at("2-contact.json").document->at("result")["samples"][1];
    };
    document["samples"][1]["poisson_ratio"] = 0.25;
    const Json elastic = modulus_of();
    document["wall"] = {{"rigid", true}};
    const Json rigid = modulus_of();
    document["wall"] = {{"contact_modulus", "90 GPa"}};
    const Json given = modulus_of();
    const double particle = 1.0 / rigid["contact_modulus"]["value"].get<double>();
    const double wall = (1 - 0.29 * 0.29) / 193e9;
    CHECK(relative_difference(1.0 / elastic["contact_modulus"]["value"].get<double>(), particle + wall) <
          1e-14);
    CHECK(given["contact_modulus"]["value"] == 90e9);
    CHECK(elastic["contact_modulus"]["standard_uncertainty"].get<double>() > 0);
}

TEST_CASE("3-analytic agrees with the dynamic JKR velocity without damping") {
    const auto& contacts = built_in_run().contact.samples;
    for (const SampleAnalytic& sample : built_in_run().analytic.samples) {
        const Law jkr = Law::of<Jkr>();
        const auto dynamic =
            critical_velocity({jkr, Detachment::pull_off, {}, named(contacts, sample.name).pair});
        CHECK(relative_difference(dynamic.value.value(), sample.critical_velocity) < 1e-12);
    }
}

TEST_CASE("4-restitution: an impact with the published damping gives the reconstructed restitution back") {
    const auto& contacts = built_in_run().contact.samples;
    const auto& restitutions = built_in_run().restitution.samples;
    for (const SampleRestitution& sample : restitutions) {
        const RestitutionSeries* jkr = sample.of(Law::of<Jkr>());
        const RestitutionSeries* brach_dunn = sample.of(Law::of<BrachDunn>());
        REQUIRE(jkr != nullptr);
        CHECK(jkr == brach_dunn);  // the reference law's points
        CHECK(jkr->origin == Origin::reconstructed);
        const auto& points = jkr->impacts.points;
        CHECK(std::is_sorted(points.begin(), points.end(),
                             [](const auto& a, const auto& b) { return a.velocity < b.velocity; }));
        CHECK(points.size() == 10);
        CHECK(jkr->coefficient_uncertainty.value() == doctest::Approx(1e-4 / std::sqrt(12.0)));
    }
    const RestitutionSeries* series = named(restitutions, "88 um").of(Law::of<Dmt>());
    const double e = series->impacts.points[3].restitution();
    const double eta = 0.0223 * e * e - 0.0279 * e + 0.0151;
    const ImpactResult impact = solve_impact({Law::of<Dmt>(),
                                              Detachment::zero_overlap,
                                              {DampingLaw::constant, eta},
                                              named(contacts, "88 um").pair,
                                              series->impacts.points[3].velocity});
    CHECK(relative_difference(impact.restitution, e) < 1e-10);
}

TEST_CASE("6-fit: Table 2 and Table 3 come back from the reconstructed points") {
    const std::map<std::string, std::map<std::string, std::array<double, 3>>> table_2{
        {"88 um",
         {{"hertz", {0.0238, -0.0291, 0.0153}},
          {"dmt", {0.0223, -0.0279, 0.0151}},
          {"brach-dunn", {0.0193, -0.0247, 0.0141}}}},
        {"96 um",
         {{"hertz", {0.0104, -0.0229, 0.0155}},
          {"dmt", {0.0115, -0.0235, 0.0156}},
          {"brach-dunn", {0.0101, -0.0213, 0.0149}}}},
        {"104 um",
         {{"hertz", {0.0074, -0.0217, 0.0163}},
          {"dmt", {0.0065, -0.0206, 0.0160}},
          {"brach-dunn", {0.0043, -0.0170, 0.0145}}}}};
    const auto& fits = built_in_run().fit.samples;
    for (const auto& [name, laws] : table_2)
        for (const auto& [law, fit] : laws) {
            const LawFit* own = named(fits, name).laws.find(Law::named(law));
            REQUIRE(own != nullptr);
            CHECK(std::abs(own->damping.coefficients[2] - fit[0]) < 1e-9);
            CHECK(std::abs(own->damping.coefficients[1] - fit[1]) < 1e-9);
            CHECK(relative_difference(own->critical_damping, fit[2]) < 1e-9);
        }
}

TEST_CASE("7-critical-velocity: captured just below, rebounding just above, for every law") {
    const auto& contacts = built_in_run().contact.samples;
    const auto& fits = built_in_run().fit.samples;
    for (const auto& sample : built_in_run().critical_velocity.samples) {
        const ContactPair& contact = named(contacts, sample.name).pair;
        int laws = 0;
        for (const auto& [law, velocity] : sample.laws) {
            const double eta = named(fits, sample.name).laws.find(law)->critical_damping;
            Impact impact{law, law.default_detachment(), {DampingLaw::constant, eta}, contact, 0};
            impact.velocity = velocity.velocity.value().value * (1 - 1e-6);
            CHECK(solve_impact(impact).outcome == Outcome::capture);
            impact.velocity = velocity.velocity.value().value * (1 + 1e-6);
            CHECK(solve_impact(impact).outcome == Outcome::rebound);
            ++laws;
        }
        CHECK(laws == 5);
    }
}

TEST_CASE("8-histories: columns of the stated length, contact ends where it began, momentum closes") {
    for (const auto& sample : result("8-histories.json")["samples"]) {
        for (const auto* law : {"hertz", "dmt", "brach-dunn", "jkr"}) {
            REQUIRE(sample[law].size() == 2);
            CHECK(sample[law][0]["part"] == "critical");
            CHECK(sample[law][1]["part"] == "rising");
            for (const auto& history : sample[law]) {
                const auto& trajectory = history["trajectory"];
                for (const auto& [name, column] : trajectory.items()) CHECK(column["values"].size() == 49);
                CHECK(trajectory["time"]["values"].back().get<double>() ==
                      doctest::Approx(history["contact_time"]["value"].get<double>()));
                const auto& momentum = history["momentum"];
                const double lost = momentum["equation_44"]["momentum_lost"]["value"];
                for (const auto* part : {"approach", "rebound"})
                    CHECK(std::abs(momentum[part]["residual"]["value"].get<double>()) < 1e-12 * lost);
                const auto side = [&](const char* equation, const char* name) {
                    return momentum[equation][name]["value"].template get<double>();
                };
                CHECK(std::abs(side("equation_41", "left") - side("equation_41", "right")) < 1e-12 * lost);
                CHECK(side("equation_42", "left") > side("equation_42", "right"));
                const auto term = [&](const char* name) {
                    return history["energy"][name]["value"].template get<double>();
                };
                const double incident = term("incident");
                CHECK(std::abs(term("remaining") + term("potential") - term("at_touch") + term("dissipated") +
                               term("plastic") + term("jumps") + term("residual") - incident) <
                      1e-12 * incident);
                CHECK(std::abs(side("equation_43", "right") - side("equation_43", "left") -
                               (term("potential") - term("at_touch"))) < 1e-9 * incident);
                CHECK(momentum["verdict"].get<std::string>().starts_with("(44) holds: damping impulse "));
            }
        }
    }
}

TEST_CASE("comparison: fixed places, published values beside ours, the ratio in the sentence") {
    const Json& comparison = result("comparison.json");
    REQUIRE(comparison["samples"].size() == 3);
    const Json& sample = comparison["samples"][2];
    CHECK(sample["name"] == "104 um");
    CHECK(sample["measured_critical_velocity"]["value"] == 0.69);
    CHECK(sample["published"]["critical_velocity"]["dmt"]["published"]["value"] == 0.64);
    const double ours = sample["dynamic_critical_velocity"]["dmt"]["value"];
    CHECK(relative_difference(
              sample["published"]["critical_velocity"]["dmt"]["relative_difference"].get<double>(),
              ours / 0.64 - 1) < 1e-12);
    CHECK(sample["published"]["contact_times"][0]["law"] == "brach-dunn");
    CHECK_FALSE(sample["published"]["critical_velocity"].contains("jkr"));
    double least = 1e300;
    for (const auto& each : comparison["samples"])
        for (const auto& [law, velocity] : each["dynamic_critical_velocity"].items())
            least = std::min(least, velocity["value"].get<double>() /
                                        each["analytic_critical_velocity"]["value"].get<double>());
    CHECK(relative_difference(comparison["dynamic_over_analytic"]["least"].get<double>(), least) < 1e-14);
    CHECK(comparison["conclusion"].get<std::string>() == test::containing("viscous dissipation does"));
}

TEST_CASE("comparison: sizes and laws at equal velocities, between the points of each series") {
    const auto& dampings = built_in_run().damping.samples;
    const Json& equal = result("comparison.json")["equal_velocities"];
    REQUIRE(equal.size() >= 5);
    std::size_t rows = 0;
    std::map<std::string, std::map<std::string, double>> at_three;
    double before = 0.0;
    for (const Json& entry : equal) {
        const double v = entry["velocity"]["value"];
        CHECK(v > before);
        before = v;
        for (const Json& row : entry["impacts"]) {
            CAPTURE(v);
            CAPTURE(row.dump());
            const Law law = Law::named(row["law"].get<std::string>());
            const DampingSeries* series = named(dampings, row["sample"].get<std::string>()).laws.find(law);
            REQUIRE(series != nullptr);
            // The velocities of these series increase: between which points v lies.
            const auto next = std::upper_bound(series->velocity.begin(), series->velocity.end(), v);
            REQUIRE(next != series->velocity.begin());
            REQUIRE(next != series->velocity.end());
            const auto i = static_cast<std::size_t>(next - series->velocity.begin());
            const auto between = [&](const char* key, const std::vector<double>& values, double slack) {
                const double value = row[key]["value"];
                const auto [least, greatest] = std::minmax(values[i - 1], values[i]);
                CHECK(value >= least * (1.0 - slack));
                CHECK(value <= greatest * (1.0 + slack));
            };
            between("damping", series->damping, 1e-12);
            between("restitution", series->restitution, 1e-9);
            between("contact_time", series->contact_time, 1e-9);
            CHECK(row["maximum_overlap"]["value"].get<double>() > 0);
            if (v == 3.0) at_three[row["law"]][row["sample"]] = row["damping"]["value"];
            ++rows;
        }
    }
    CHECK(rows > 50);
    // Figure 8: the smaller the particle, the more damping at equal velocity.
    for (const char* law : {"hertz", "dmt", "brach-dunn", "jkr"})
        CHECK(at_three[law].at("88 um") > at_three[law].at("96 um"));
}

TEST_CASE("shared velocities are round, within two ranges, and none where ranges do not overlap") {
    CHECK(shared_velocities({}).empty());
    CHECK(shared_velocities({{1.0, 8.0}}).empty());
    CHECK(shared_velocities({{0.1, 0.4}, {0.5, 3.0}}).empty());
    CHECK(shared_velocities({{0.25, 7.0}, {0.3, 9.0}}) ==
          std::vector<double>{0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.5, 2, 3, 4, 5, 6});
    CHECK(shared_velocities({{0.01, 60.0}, {0.01, 100.0}}).size() == 12);
    // Of three ranges two are enough.
    CHECK(shared_velocities({{1.0, 2.0}, {1.7, 4.0}, {3.4, 9.0}}) == std::vector<double>{1.8, 2, 3.5, 4});
}

TEST_CASE("measured data: captures are kept apart and the falling branch is left out of the fit") {
    const Artifacts artifacts = computed_from(example_under("dmt"), "fit");
    const Json& fine = artifacts.at("5-damping.json").document->at("result")["samples"][0]["dmt"];
    CHECK(fine["captured_at"]["values"] == Json{1.4, 1.55});
    CHECK(fine["velocity"]["values"].size() == 10);
    const Json& coarse = artifacts.at("6-fit.json").document->at("result")["samples"][1]["dmt"];
    const std::size_t points = coarse["points"];
    CHECK(points >= 14);  // e rises up to about 2 m/s
    CHECK(points <= 16);
    CHECK(coarse["points_beyond_rising_branch"].get<std::size_t>() == 18 - points);
    CHECK(coarse["origin"] == "measured");
    CHECK(coarse["degrees_of_freedom"] == points - 3);
    CHECK(coarse["critical_damping"]["standard_uncertainty"].get<double>() > 0);
}

TEST_CASE("a sample without restitution data still gets its analytic velocity, and a warning") {
    Json document = example_under("jkr");
    document["samples"][1].erase("restitution");
    const Artifacts artifacts = computed_from(document);
    const Json& sample = artifacts.at("comparison.json").document->at("result")["samples"][1];
    CHECK(sample["analytic_critical_velocity"]["value"].get<double>() > 0);
    CHECK(sample["dynamic_critical_velocity"]["jkr"].is_null());
    CHECK(sample["verdict"]["jkr"] == "no damping data");
    CHECK(sample["reported"]["reason"] == "no impacts were given");
    CHECK(artifacts.at("4-restitution.json").document->at("warnings").size() == 1);
}

TEST_CASE("other damping laws go through every stage, with their unit") {
    Json document = test::with_one_sample(test::example_case(), {"jkr"});
    for (const auto& [law, unit] :
         std::map<std::string, std::string>{{"contact-radius", "Pa s"}, {"tsuji", "1"}}) {
        document["damping_law"] = law;
        const Artifacts artifacts = computed_from(document);
        const Json& fit = artifacts.at("6-fit.json").document->at("result")["samples"][0]["jkr"];
        CHECK(fit["critical_damping"]["unit"] == unit);
        const Json& velocity =
            artifacts.at("7-critical-velocity.json").document->at("result")["samples"][0]["jkr"];
        CHECK(velocity["damping_law"] == law);
        CHECK(velocity["verdict"].is_string());
    }
}

TEST_CASE("a parameter of a law goes from the particle of a case through the artifacts to every stage") {
    Json document = test::example_case();
    document["laws"] = {"sjkr"};
    document.erase("work_of_adhesion");
    CHECK_THROWS_WITH_AS(static_cast<void>(computed_from(document)),
                         doctest::Contains("/samples/0: cohesion_energy_density is missing, here and in "
                                           "\"particle\", for law \"sjkr\""),
                         InputError);
    document["particle"]["cohesion_energy_density"] = "100 MJ/m3";
    document["samples"][0]["cohesion_energy_density"] = {
        {"value", 50}, {"unit", "MJ/m3"}, {"standard_uncertainty", 5}, {"source", "calibrated"}};
    const Artifacts artifacts = computed_from(document);
    const Json& contact = artifacts.at("2-contact.json").document->at("result")["samples"][0];
    CHECK(contact["cohesion_energy_density"]["value"] == 50e6);
    CHECK(contact["cohesion_energy_density"]["unit"] == "Pa");
    CHECK(contact["cohesion_energy_density"]["source"] == "calibrated");
    const Json& velocity =
        artifacts.at("7-critical-velocity.json").document->at("result")["samples"][0]["sjkr"];
    CHECK(velocity["critical_velocity"]["value"].get<double>() > 0);
}

TEST_CASE("without adhesive laws no work of adhesion is needed") {
    Json document = test::with_one_sample(test::example_case(), {"hertz"});
    document.erase("work_of_adhesion");
    const Artifacts artifacts = computed_from(document);
    const Json& comparison = artifacts.at("comparison.json").document->at("result");
    CHECK(comparison["samples"][0]["analytic_critical_velocity"]["value"] == 0);
    CHECK(comparison["conclusion"].get<std::string>() == test::containing("there is none to compare"));
}

TEST_CASE("a published contact time that states no uncertainty counts with a thousandth of itself") {
    LoadedCase loaded = load_case(std::nullopt);
    for (Sample& sample : loaded.data.samples)
        for (auto& time : sample.published.value().contact_times)
            time.contact_time.standard_uncertainty.reset();
    const CalibrationProblem problem =
        calibration_problem(loaded.data, built_in_run().modulus, built_in_run().contact);
    REQUIRE(problem.contact_times.size() == 3);
    for (const auto& time : problem.contact_times)
        CHECK(relative_difference(time.standard_uncertainty, 1e-3 * time.value) < 1e-14);
}
