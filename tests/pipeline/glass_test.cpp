// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "materials/glass/balance.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::computed_from;
using test::containing;
using test::edited;
using test::example_under;
using test::input_error_of;
using test::relative_difference;

namespace {

/// Of the glass of the sample "fine" of the example: 30 SiO2, 8 Al2O3, 2.5 Fe2O3, 3 CaO, 2 K2O, 1 MgO and 0.5
/// TiO2 of 47 %, with 1.643 % quartz, 50.456 % mullite and 0.901 % hematite beside it.
constexpr auto oxides_of_fine =
    R"({"SiO2": "45.874 %", "Al2O3": "44.225 %", "Fe2O3": "3.401 %", "CaO": "3 %", "K2O": "2 %", "MgO": "1 %",
        "TiO2": "0.5 %"})";

/// The sample "fine" of the example under one law, with its oxides.
Json example_with_oxides(const std::string& glass) {
    Json document = test::with_one_sample(example_under("dmt"), {"dmt"});
    Json& composition = document["samples"][0]["composition"];
    composition["oxides"] = Json::parse(oxides_of_fine);
    if (!glass.empty()) composition["glass"] = glass;
    return document;
}

const Json& sample_of(const Artifacts& artifacts, std::string_view file) {
    return artifacts.at(file).document->at("result").at("samples").at(0);
}

const Artifacts& from_chemistry() {
    static const Artifacts artifacts = computed_from(example_with_oxides("from-chemistry"));
    return artifacts;
}

const Artifacts& beside_catalogue() {
    static const Artifacts artifacts = computed_from(example_with_oxides(""));
    return artifacts;
}

double number(const Json& quantity) {
    return quantity.at("value").get<double>();
}

}  // namespace

TEST_CASE("1-modulus.json: composition, modulus, Poisson's ratio and density of the glass") {
    const Json& glass = sample_of(from_chemistry(), modulus_artifact).at("glass");
    CHECK(glass.at("used") == true);
    CHECK(std::abs(number(glass.at("composition").at("SiO2")) - 30.0 / 47) < 2e-4);
    CHECK(std::abs(number(glass.at("composition").at("CaO")) - 3.0 / 47) < 2e-4);
    CHECK(std::abs(number(glass.at("weight_fraction")) - 0.47) < 2e-5);
    CHECK(number(glass.at("density")) == 2500);
    OxideAmounts oxides_of_glass = no_oxides();
    for (const auto& [oxide, amount] : glass.at("composition").items())
        oxides_of_glass[oxide_index(oxide)] = number(amount);
    const ElasticBody body = makishima_mackenzie(oxides_of_glass, 2500);
    CHECK(relative_difference(number(glass.at("young_modulus")), body.young_modulus) < 1e-12);
    CHECK(relative_difference(number(glass.at("poisson_ratio")), body.poisson_ratio) < 1e-12);
    CHECK(glass.at("young_modulus").at("standard_uncertainty").get<double>() > 0.08 * body.young_modulus);
    const Json& phases = sample_of(from_chemistry(), modulus_artifact).at("phases");
    CHECK(phases.back().at("phase") == "glass-from-chemistry");
    CHECK(from_chemistry().at(modulus_artifact).document->at("citations").dump() ==
          containing("makishima1973"));
}

TEST_CASE("oxides beside the catalogue's glass change no number of a run") {
    const Artifacts plain = computed_from(test::with_one_sample(example_under("dmt"), {"dmt"}));
    Json beside = sample_of(beside_catalogue(), modulus_artifact);
    CHECK(beside.at("glass").at("used") == false);
    beside.erase("glass");
    CHECK(beside == sample_of(plain, modulus_artifact));
    for (const auto file : {contact_artifact, critical_velocity_artifact})
        CHECK(sample_of(beside_catalogue(), file) == sample_of(plain, file));
    CHECK_FALSE(sample_of(plain, modulus_artifact).contains("glass"));
    CHECK_FALSE(sample_of(plain, comparison_artifact).contains("glass"));
}

TEST_CASE("comparison.json says what the chemistry of the glass changes, from either side") {
    const Json& used = sample_of(from_chemistry(), comparison_artifact).at("glass");
    const Json& unused = sample_of(beside_catalogue(), comparison_artifact).at("glass");
    CHECK(used.at("used") == "from-chemistry");
    CHECK(unused.at("used") == "catalogue");
    for (const char* key : {"young_modulus", "contact_modulus", "analytic_critical_velocity"})
        for (const char* glass : {"catalogue", "from_chemistry"}) {
            CAPTURE(key);
            CAPTURE(glass);
            CHECK(relative_difference(number(used.at(key).at(glass)), number(unused.at(key).at(glass))) <
                  1e-12);
        }
    const auto modulus = [](const Artifacts& artifacts) {
        return number(sample_of(artifacts, modulus_artifact).at("young_modulus"));
    };
    CHECK(number(used.at("young_modulus").at("catalogue")) == modulus(beside_catalogue()));
    CHECK(number(used.at("young_modulus").at("from_chemistry")) == modulus(from_chemistry()));
    CHECK(modulus(from_chemistry()) > 1.02 * modulus(beside_catalogue()));
    const auto dynamic = [](const Artifacts& artifacts) {
        return number(sample_of(artifacts, critical_velocity_artifact).at("dmt").at("critical_velocity"));
    };
    CHECK(number(used.at("dynamic_critical_velocity").at("from_chemistry")) == dynamic(from_chemistry()));
    CHECK(number(unused.at("dynamic_critical_velocity").at("catalogue")) == dynamic(beside_catalogue()));
    const std::string text =
        comparison_text(from_chemistry().at(comparison_artifact).document->at("result"), 200);
    CHECK(text == containing("Glass of the catalogue -> glass from its chemistry:\n  fine: E "));
    CHECK(text == containing("; the chemistry counts"));
}

TEST_CASE("artifacts with a glass read back to the same run") {
    const Run run = read_run(from_chemistry());
    CHECK(result_json(run, modulus_artifact) == from_chemistry().at(modulus_artifact).document->at("result"));
    CHECK(result_json(run, comparison_artifact) ==
          from_chemistry().at(comparison_artifact).document->at("result"));
    CHECK(case_json(run.data) == from_chemistry().at(case_artifact).document->at("result"));
}

TEST_CASE("oxides and glass of a case: what contradicts itself is refused at its place") {
    const auto refusal = [](const std::string& edits, const std::string& glass = "") {
        return input_error_of(
            [&] { return computed_from(edited(example_with_oxides(glass), edits), "modulus"); });
    };
    const std::string composition = "/samples/0/composition";
    CHECK(refusal("- " + composition + "/oxides", "from-chemistry") ==
          containing(
              "/samples/0/composition/glass: the glass is to come from chemistry, and the sample \"fine\""));
    CHECK(refusal(composition + "/oxides_sample = \"A\"") == containing("belongs to a file of oxides"));
    CHECK(refusal(composition + "/oxides/Al2O3 = 0.2") ==
          containing("/samples/0/composition: the oxides add up"));
    CHECK(refusal(composition + "/oxides/Al2O3 = 0.3 ; " + composition + "/oxides/SiO2 = 0.6") ==
          containing("Al2O3, more than the whole sample"));
    CHECK(refusal(composition + "/oxides/SiO3 = 0.2") == containing("no oxide is called \"SiO3\""));
    CHECK(refusal(composition + "/glass = \"slag\"") == containing("/samples/0/composition/glass"));
    CHECK(refusal("- " + composition + "/oxides ; " + composition + "/glass_density = 2500") ==
          containing("belongs to a glass from chemistry"));
    CHECK(refusal("") == "");
}
