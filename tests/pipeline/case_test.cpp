// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/case.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/schema.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::relative_difference;
using test::Sandbox;

namespace {

/// The case that a document makes, its files taken from the example.
LoadedCase loaded(const Json& document) {
    const Sandbox sandbox;
    test::write_example(sandbox, document);
    return load_case(sandbox.path("case.json"));
}

/// Reading the normalised case again, without any file or catalogue.
Json normalised_again(const Json& normalised) {
    validate_document(normalised, "case");
    InputFiles none = InputFiles::beside({});
    return case_json(read_case(View(normalised), PhaseCatalogue({}), none));
}

}  // namespace

TEST_CASE("the built-in case: the paper's samples, its published values, and what is inferred marked so") {
    const LoadedCase built_in = load_case(std::nullopt);
    const Case& data = built_in.data;
    REQUIRE(data.samples.size() == 3);
    CHECK(data.samples[0].name == "88 um");
    CHECK(relative_difference(data.samples[2].diameter.value(), 104e-6) < 1e-15);
    REQUIRE(data.wall);
    for (const Sample& sample : data.samples) {
        REQUIRE(sample.density);
        CHECK(sample.density->origin == Origin::inferred);
        CHECK_FALSE(sample.density->source.empty());
        CHECK(std::get<Stated>(sample.work_of_adhesion.value()).origin == Origin::inferred);
        REQUIRE(sample.published);
        CHECK(sample.measured_critical_velocity->origin == Origin::measured);
        CHECK(std::holds_alternative<Reconstruction>(sample.restitution.value()));
    }
    const PublishedSample& published = *data.samples[1].published;
    const DampingPolynomial* fit = published.damping_fits.find(Law::of<Dmt>());
    REQUIRE(fit != nullptr);
    CHECK((*fit == DampingPolynomial::quadratic(0.0115, -0.0235, 0.0156)));
    const Quantity* velocity = published.critical_velocity.find(Law::of<BrachDunn>());
    REQUIRE(velocity != nullptr);
    CHECK(velocity->value == 1.27);
    CHECK(relative_difference(velocity->standard_uncertainty.value(), 0.01 / std::sqrt(12.0)) < 1e-14);
    CHECK(built_in.inputs.size() == 2);
    CHECK(built_in.inputs[0].file == "builtin:cases/dong2013/case.json");
}

TEST_CASE("a normalised case stands for itself: read again it is the same, byte for byte") {
    for (const Case& data : {load_case(std::nullopt).data, loaded(test::example_case()).data}) {
        const Json once = case_json(data);
        CHECK(normalised_again(once) == once);
    }
}

TEST_CASE("a normalised case keeps every way of saying things") {
    Json document = test::example_case();
    document["mixture_rule"] = "hill";
    document["damping_law"] = "tsuji";
    document["detachments"] = {{"jkr", "load-controlled"}, {"hertz", "zero-force"}};
    document["work_of_adhesion"] = {
        {"surface_energies", {{"particle", "40 mJ/m2"}, {"wall", 0.5}, {"interfacial", 0.1}}},
        {"rule", "dupre"}};
    document["wall"] = {{"rigid", true}};
    document["calibration"] = {{"free", {{{"quantity", "density"}, {"per_sample", true}}}}};
    document["histories"] = {{"points", 11}, {"critical_excess", 0.01}};
    document["samples"][0]["composition"]["amorphous"] = {
        {"crystalline_total", {{"value", 53}, {"unit", "%"}, {"standard_uncertainty", 1}}}};
    document["samples"][0]["porosity"] = {{"law", "spriggs"}, {"value", "5 %"}, {"coefficient", 3}};
    document["samples"][1]["poisson_ratio"] = {{"value", 0.2}, {"unit", "1"}, {"origin", "assumed"}};
    document["samples"][1]["contact_modulus"] = "88 GPa";
    document["samples"][1]["composition"]["densities"] = {{"hematite", "5.1 g/cm3"}};
    const Json once = case_json(loaded(document).data);
    CHECK(once["mixture_rule"] == "hill");
    CHECK(once["damping_law"] == "tsuji");
    CHECK(once["detachments"]["jkr"] == "load-controlled");
    CHECK(once["wall"] == Json{{"rigid", true}});
    CHECK(once["samples"][0]["work_of_adhesion"]["rule"] == "dupre");
    CHECK(once["samples"][0]["composition"]["amorphous"]["crystalline_total"]["standard_uncertainty"] ==
          0.01);
    CHECK(once["samples"][0]["porosity"]["coefficient"] == 3.0);
    CHECK(once["samples"][1]["composition"]["densities"]["hematite"]["value"] == 5100.0);
    CHECK(normalised_again(once) == once);
}

TEST_CASE("a composition reads the same in a case and in the project's own XRD result") {
    const Sandbox sandbox;
    const std::vector<std::string> compositions{
        R"({"weight_fractions": {"quartz": "10 %", "mullite": "59 %"}, "amorphous": "31 %"})",
        R"({"phases": [{"name": "quartz", "weight_fraction": "10 %", "density": "2.66 g/cm3"},
                       {"name": "mullite", "weight_fraction": {"value": 59, "unit": "%", "standard_uncertainty": 2}}],
            "amorphous": "remainder"})",
        R"({"volume_fractions": {"quartz": "10 %", "mullite": "59 %"}, "amorphous": {"volume_fraction": "31 %"}})",
        R"({"weight_fractions": {"quartz": "30 %", "mullite": "50 %", "corundum": "20 %"},
            "internal_standard": {"phase": "corundum", "added_fraction": "10 %"}})",
        R"({"peaks": [{"name": "quartz", "intensity": 300, "rir": 3}, {"name": "mullite", "intensity": 100, "rir": 2}],
            "densities": {"quartz": "2.66 g/cm3"}, "amorphous": {"crystalline_total": "58 +- 2 %"}})"};
    for (const std::string& text : compositions) {
        CAPTURE(text);
        Json document = test::example_case();
        document["samples"].erase(1);
        document["samples"][0]["composition"] = Json::parse(text);
        const Json inside = case_json(loaded(document).data)["samples"][0]["composition"];
        Json sample = Json::parse(text);
        sample["name"] = "a";
        sandbox.write("ash.json", Json{{"samples", {sample}}}.dump());
        document["samples"][0]["composition"] = {{"xrd", "ash.json"}};
        test::write_example(sandbox, document);
        Json from_file = case_json(load_case(sandbox.path("case.json")).data)["samples"][0]["composition"];
        from_file.erase("source");
        CHECK(from_file == inside);
    }
}

TEST_CASE("units: a string, an object and a bare SI number say the same") {
    Json document = test::example_case();
    for (const Json& diameter : {Json("88 um"), Json{{"value", 0.088}, {"unit", "mm"}}, Json(88e-6)}) {
        document["samples"][0]["diameter"] = diameter;
        CHECK(relative_difference(loaded(document).data.samples[0].diameter.value(), 88e-6) < 1e-15);
    }
}

TEST_CASE("the scatter of sizes is a fraction, as on the command line") {
    for (const Json& scatter : {Json(0.05), Json("5 %"), Json{{"value", 5}, {"unit", "%"}}}) {
        CAPTURE(scatter.dump());
        CHECK(loaded(test::edited(test::example_case(), "/fit = " + Json{{"size_scatter", scatter}}.dump()))
                  .data.fit.estimate.size_scatter == 0.05);
    }
    for (const char* wrong : {"\"60 %\"", "0", "\"5 +- 1 %\"", "\"5 um\""}) {
        CAPTURE(wrong);
        const Json document =
            test::edited(test::example_case(), std::string("/fit = {\"size_scatter\": ") + wrong + "}");
        CHECK(test::contains(test::input_error_of([&] { return loaded(document); }), "/fit/size_scatter: "));
    }
}

TEST_CASE("the uncertainty of the scale of all velocities is a fraction, as on the command line") {
    const auto of_fit = [](const std::string& value) {
        return test::edited(test::example_case(), "/fit = {\"velocity_scale_uncertainty\": " + value + "}");
    };
    for (const char* stated : {"0.03", "\"3 %\""})
        CHECK(loaded(of_fit(stated)).data.fit.estimate.scale_uncertainty == 0.03);
    for (const char* wrong : {"\"60 %\"", "0", "\"3 +- 1 %\"", "\"3 m/s\"", "0.3", "\"0.3\""}) {
        CAPTURE(wrong);
        CHECK(test::contains(test::input_error_of([&] { return loaded(of_fit(wrong)); }),
                             "/fit/velocity_scale_uncertainty: "));
    }
    CHECK(loaded(of_fit("\"30 %\"")).data.fit.estimate.scale_uncertainty == 0.3);
    CHECK(test::contains(test::input_error_of([&] { return loaded(of_fit("0.3")); }),
                         "0.3 without a unit is 30 % or 0.3 %; allowed: \"30 %\" or \"0.3 %\""));
}

TEST_CASE("two sieves give evenly distributed diameters between their meshes, with a note") {
    Json document = test::example_case();
    for (const char* meshes : {"80-100 um", "0.08 to 0.1 mm", "80 um \u2013 100 um"}) {
        document["samples"][1]["diameter"] = meshes;
        const LoadedCase read = loaded(document);
        const Stated& diameter = read.data.samples[1].diameter;
        CAPTURE(meshes);
        CHECK(relative_difference(diameter.value(), 90e-6) < 1e-14);
        CHECK(relative_difference(*diameter.quantity.standard_uncertainty, 20e-6 / std::sqrt(12.0)) < 1e-13);
        CHECK(std::ranges::any_of(read.findings, [](const SampleFinding& each) {
            return each.finding.code == "sieve" && each.finding.text.ends_with("would be 0.064");
        }));
    }
    for (const char* wrong : {"100-80 um", "80-100", "-100 um", "0-100 um", "80-100 kg", "1e-6-2e-6 m"}) {
        document["samples"][1]["diameter"] = wrong;
        CHECK_THROWS_AS(static_cast<void>(loaded(document)), InputError);
    }
    document["samples"][1]["diameter"] = "80-100";
    CHECK(
        test::input_error_of([&] { static_cast<void>(loaded(document)); }) ==
        test::containing("/samples/1/diameter: the meshes \"80-100\" have no unit; allowed: \"80-100 um\""));
    document["samples"][1]["diameter"] = "9e-5 m";
    CHECK(loaded(document).data.samples[1].diameter.value() == 9e-5);
}

TEST_CASE("a statement of a case that changes nothing is named with the reason; a default is none") {
    const auto unused = [](const Json& document) {
        std::vector<std::string> texts;
        for (const SampleFinding& each : loaded(document).findings)
            if (each.finding.code == unused_code) texts.push_back(each.sample + each.finding.text);
        return texts;
    };
    const Json example = test::with_one_sample(test::example_case(), {"hertz", "dmt"});
    CHECK(unused(example).empty());
    CHECK(unused(case_json(loaded(example).data)).empty());  // its options are all stated, as defaults
    for (const auto& [edits, said] : std::vector<std::pair<std::string, std::string>>{
             {R"(/samples/0/contact_modulus = "90 GPa")",
              "/wall changes nothing, as every sample states its contact_modulus"},
             {R"(/samples/0/poisson_ratio = 0.2 ; /wall = {"contact_modulus": "90 GPa"})",
              "fine/samples/0/poisson_ratio changes no impact, as the contact_modulus of both bodies is "
              "stated"},
             {"/particle = {\"density\": 2300}",
              "/particle/density changes no impact, as every sample states its own"},
             {"/particle = {\"tabor\": 2}",
              "/particle/tabor changes no impact, as none of hertz, dmt uses it"},
             {"/samples/0/cohesion_energy_density = \"1 MJ/m3\"",
              "fine/samples/0/cohesion_energy_density changes no impact, as none of hertz, dmt uses it"},
             {"/laws = [\"hertz\"]", "/work_of_adhesion changes no impact, as hertz does not use it"},
             {"/laws = [\"hertz\"] ; - /work_of_adhesion ; /roughness = \"1 nm\"",
              "/roughness changes no impact, as hertz does not use it"},
             {"- /samples/0/restitution", "/camera changes nothing, as no sample has measured impacts"},
             {R"(/samples/0/restitution/camera = {"frame_rate": 1e5, "pixel_size": "2 um"})",
              "/camera changes nothing, as the impacts of every sample state their uncertainty or a camera "
              "of "
              "their own"},
             {"/damping_law = \"tsuji\" ; /fit = {\"order\": 3}",
              "/fit/order changes nothing, as that takes constant damping"},
             {"/fit = {\"direct_order\": 3}",
              "/fit/direct_order changes nothing, as it is of earlier versions"},
             {"- /samples/0/restitution ; - /camera ; /histories = {\"points\": 9}",
              "/histories/points changes nothing, as no sample has restitution data"},
             {"- /samples/0/restitution ; - /camera ; /friction = 0.2",
              "/friction changes nothing, as no sample has restitution data"},
             {"/published = \"dong2013\"",
              "/published changes nothing, as it has values of none of the samples"},
             {R"(/phases = [{"name": "opal", "density": "2 g/cm3", "young_modulus": "50 GPa"}])",
              "phases of /phases that no sample has change nothing (opal)"}}) {
        CAPTURE(edits);
        CHECK(unused(test::edited(example, edits)) == std::vector{said});
    }
    Json energies = example;
    energies["work_of_adhesion"] = {{"surface_energies", {{"particle", 0.04}, {"partner", 0.5}}},
                                    {"rule", "girifalco-good"}};
    CHECK(
        test::input_error_of([&] { static_cast<void>(loaded(energies)); }) ==
        test::containing("case.json: /work_of_adhesion/surface_energies/partner: the other body is a wall"));
}

TEST_CASE("what a sample does not state it takes from the case") {
    Json document = test::example_case();
    document["particle"].update({{"density", "2000 kg/m3"}, {"poisson_ratio", 0.21}});
    document["samples"][1].erase("density");
    document["samples"][1]["work_of_adhesion"] = 0.1;
    const Case data = loaded(document).data;
    CHECK(data.samples[0].density->value() == 2300);
    CHECK(data.samples[1].density->value() == 2000);
    CHECK(data.samples[0].poisson_ratio->value() == 0.21);
    CHECK(std::get<Stated>(*data.samples[0].work_of_adhesion).value() == 0.3);
    CHECK(std::get<Stated>(*data.samples[1].work_of_adhesion).value() == 0.1);
}

TEST_CASE("a phase of the user's own hides the catalogue's") {
    Json document = test::example_case();
    document["phases"] = {{{"name", "mullite"}, {"density", "2.8 g/cm3"}, {"young_modulus", "200 GPa"}}};
    const Case data = loaded(document).data;
    for (const Phase& phase : data.phases)
        if (phase.name == "mullite") CHECK(phase.young_modulus.value == 200e9);
    CHECK(loaded(test::example_case()).data.phases.size() == data.phases.size());
}

TEST_CASE("published values come from a file of the user as well") {
    const Sandbox sandbox;
    Json document = test::example_case();
    document["published"] = "paper.json";
    test::write_example(sandbox, document);
    sandbox.write("paper.json", R"({"source": "A paper", "rounding": {"critical_velocity": "0.1 m/s"},
        "samples": {"coarse": {"critical_velocity": {"hertz": "0.5 m/s"}}}})");
    const LoadedCase read = load_case(sandbox.path("case.json"));
    CHECK_FALSE(read.data.samples[0].published);
    REQUIRE(read.data.samples[1].published);
    CHECK(read.data.samples[1].published->source == "A paper");
    CHECK(read.data.samples[1].published->critical_velocity.find(Law::of<Hertz>())->value == 0.5);
    CHECK(read.inputs.size() == 4);  // case, paper.json, ash.csv, impacts.csv
}

TEST_CASE("measured impacts come from a table, with its warnings and its mistakes by line") {
    const Sandbox sandbox;
    test::write_example(sandbox, test::example_case());
    sandbox.write("impacts.csv", "nr;v_in [cm/s];v_r [mm/s]\n1;200;500\n2;400;0\n");
    const LoadedCase read = load_case(sandbox.path("case.json"));
    const auto& data = std::get<MeasuredRestitution>(read.data.samples[0].restitution.value());
    CHECK(data.source == test::containing("80000 frames/s"));
    REQUIRE(data.impacts.points.size() == 2);
    CHECK(data.impacts.points[0].velocity == 2.0);
    CHECK(data.impacts.points[0].restitution() == 0.25);
    CHECK(data.impacts.points[1].captured());
    REQUIRE(read.findings.size() == 2);
    CHECK(read.findings[0].finding.text == test::containing("\"nr\" is not used"));
    CHECK(read.findings[1].finding.text == test::containing("still of the example"));

    Json twice = test::example_case();
    twice["samples"].push_back(twice["samples"][0]);
    twice["samples"].back()["name"] = "twin";
    sandbox.write("case.json", twice.dump());
    const auto of_both = load_case(sandbox.path("case.json")).findings;
    const auto shared = std::ranges::find(of_both, std::string_view("shared-impacts"),
                                          [](const SampleFinding& each) { return each.finding.code; });
    REQUIRE(shared != of_both.end());
    CHECK(shared->sample == "twin");
    CHECK(shared->finding.severity == Severity::doubt);
    sandbox.write("case.json", test::example_case().dump());

    sandbox.write("impacts.csv", "v_in [m/s],v_r [m/s]\n2,0.5\n4,x\n");
    const std::string message = test::input_error_of([&] { return load_case(sandbox.path("case.json")); });
    CHECK_MESSAGE(message.starts_with(sandbox.path("case.json") + ": /samples/0/restitution/file: " +
                                      sandbox.path("impacts.csv") + ": line 3, cell 2: \"x\""),
                  message);
}

TEST_CASE("the camera of the case gives an uncertainty to impacts that have none; bins make it smaller") {
    const Sandbox sandbox;
    Json document = test::example_case();
    document["camera"] = {{"frame_rate", 80000}, {"pixel_size", "2 um"}, {"frames", 3}};
    document["samples"][1]["restitution"]["binning"] = {{"impacts_per_bin", 6}};
    test::write_example(sandbox, document);
    const LoadedCase read = load_case(sandbox.path("case.json"));
    const auto& fine = std::get<MeasuredRestitution>(read.data.samples[0].restitution.value());
    // slope of a line through three positions, 1/sqrt(12) pixel each: 2e-6/sqrt(12) 8e4 sqrt(12/24)
    const double u = 2e-6 * 8e4 / std::sqrt(24.0);
    REQUIRE(fine.impacts.has_noise());
    CHECK(relative_difference(std::sqrt(fine.impacts.points[0].noise->incident), u) < 1e-5);
    const auto& coarse = std::get<MeasuredRestitution>(read.data.samples[1].restitution.value());
    REQUIRE(coarse.impacts.points.size() == 5);  // two captures and 18 rebounds in sixes
    CHECK(coarse.impacts.captures() == 2);
    CHECK(coarse.impacts.points[2].count == 6);
    CHECK(relative_difference(std::sqrt(coarse.impacts.points[2].noise->rebound), u / std::sqrt(6.0)) < 1e-5);
}

TEST_CASE("the complete case reads back as the same impacts, with their uncertainties") {
    const Sandbox sandbox;
    Json document = test::example_case();
    document.erase("camera");
    Json& data = document["samples"][1]["restitution"];
    data["velocity_uncertainty"] = std::vector<double>(20, 0.02);
    data["restitution_uncertainty"] = std::vector<double>(20, 0.01);
    data["rebound_resolution"] = std::vector<double>(20, 0.03);
    data["noted_capture"] = std::vector<double>(20, 0.0);
    data["noted_capture"][1] = 1.0;
    test::write_example(sandbox, document);
    const Case first = load_case(sandbox.path("case.json")).data;
    sandbox.write("again.json", case_json(first).dump());
    const Case second = load_case(sandbox.path("again.json")).data;
    for (std::size_t s = 0; s < 2; ++s) {
        const auto& a = std::get<MeasuredRestitution>(first.samples[s].restitution.value()).impacts;
        const auto& b = std::get<MeasuredRestitution>(second.samples[s].restitution.value()).impacts;
        REQUIRE(a.points.size() == b.points.size());
        CHECK(a.has_noise() == b.has_noise());
        CHECK(a.has_noise() == (s == 1));
        for (std::size_t i = 0; i < a.points.size(); ++i) {
            CHECK(a.points[i].velocity == b.points[i].velocity);
            CHECK(a.points[i].rebound == b.points[i].rebound);
            if (!a.has_noise()) continue;
            CHECK(relative_difference(a.points[i].noise->rebound, b.points[i].noise->rebound) < 1e-13);
            CHECK(std::abs(a.points[i].noise->covariance - b.points[i].noise->covariance) < 1e-17);
            for (const Measurement& point : {b.points[i], impacts_of(columns_of(a)).points[i]}) {
                CHECK(point.resolution == 0.03);
                CHECK((point.outcome == NotedOutcome::capture) == (i == 1));
            }
        }
    }
}
