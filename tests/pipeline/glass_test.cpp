// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "materials/glass/balance.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"
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
    CHECK(text == containing("it follows E* and the dynamic v_c stays."));
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

namespace {

/// The sample "fine" with its oxides, hot.
const Artifacts& hot() {
    static const Artifacts artifacts = [] {
        Json document = example_with_oxides("from-chemistry");
        document["temperature"] = Json::parse(R"({"particle": "1300 C", "wall": "400 C"})");
        return computed_from(document);
    }();
    return artifacts;
}

bool has_note(const Artifacts& artifacts, const std::string& text) {
    for (const Json& note : artifacts.at(comparison_artifact).document->at("notes"))
        if (note.at("text").get<std::string>().find(text) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("comparison.json: up to which temperature a sample stays elastic, by law and size") {
    const Json& glass = sample_of(hot(), modulus_artifact).at("glass");
    const Json& limits = sample_of(hot(), comparison_artifact).at("temperature_limits");
    CHECK(std::abs(number(limits.at("particle")) - 1573.15) < 1e-9);
    CHECK(std::abs(number(limits.at("wall")) - 673.15) < 1e-9);
    OxideAmounts melt = no_oxides();
    for (const auto& [oxide, amount] : glass.at("composition").items())
        melt[oxide_index(oxide)] = number(amount);
    const double shear = number(glass.at("young_modulus")) / (2 * (1 + number(glass.at("poisson_ratio"))));
    CHECK(relative_difference(number(limits.at("shear_modulus")), shear) < 1e-12);
    const Json& law = limits.at("laws").at("dmt");
    const Json& velocity = sample_of(hot(), critical_velocity_artifact).at("dmt");
    CHECK(number(law.at("contact_time")) == number(velocity.at("contact_time")));
    for (const ViscosityModel model : all_values<ViscosityModel>) {
        const Json& found = law.at(std::string(name_of(model)));
        const MeltViscosity viscosity(model, melt);
        const double one = std::log10(shear * number(law.at("contact_time")));
        CHECK(std::abs(viscosity.log10_at(number(found.at("elastic_up_to"))) - (one + 1)) < 1e-9);
        CHECK(std::abs(viscosity.log10_at(number(found.at("relaxation_equals_contact"))) - one) < 1e-9);
        CHECK(std::abs(viscosity.log10_at(number(found.at("liquid_from"))) - (one - 1)) < 1e-9);
        const double ratio = std::pow(10.0, viscosity.log10_at(1573.15) - one);
        CHECK(relative_difference(found.at("relaxation_over_contact").get<double>(), ratio) < 1e-9);
        CHECK(found.at("regime") == name_of(contact_regime(ratio)));
        CHECK(found.at("regime") != "elastic");
    }
    // Smaller particles touch for a shorter time, which scales with their size, and stay elastic when hotter.
    const Json& sizes = limits.at("by_size");
    REQUIRE(sizes.size() == 7);
    for (std::size_t i = 1; i < sizes.size(); ++i) {
        const double growth = number(sizes[i].at("diameter")) / number(sizes[i - 1].at("diameter"));
        CHECK(growth > 1);
        CHECK(relative_difference(number(sizes[i].at("contact_time")),
                                  growth * number(sizes[i - 1].at("contact_time"))) < 1e-9);
        CHECK(number(sizes[i].at("giordano2008").at("elastic_up_to")) <
              number(sizes[i - 1].at("giordano2008").at("elastic_up_to")));
    }
    CHECK(std::abs(number(sizes.at(4).at("diameter")) - 88e-6) < 1e-12);
}

TEST_CASE("above its elastic limit a velocity is a lower bound, in these words") {
    CHECK(has_note(hot(), "the velocity is a lower bound that elastic theory gives"));
    const std::string text = comparison_text(hot().at(comparison_artifact).document->at("result"), 200);
    CHECK(text == containing(" is a lower bound that elastic theory gives, by dmt; at 1300 C the glass is "));
    CHECK(text.find("stick below") == std::string::npos);
    const Json& result = hot().at(comparison_artifact).document->at("result");
    CHECK(result.at("reported").at("samples").at(0).at("lower_bound") == true);
    CHECK(sample_of(hot(), comparison_artifact).at("reported").at("lower_bound") == true);
    CHECK_FALSE(sample_of(from_chemistry(), comparison_artifact).at("reported").contains("lower_bound"));
    CHECK(text.find("In brackets: the interval") == std::string::npos);
    CHECK(text == containing("(particle at 1300 C, wall at 400 C)"));
    CHECK(result_json(read_run(hot()), comparison_artifact) ==
          hot().at(comparison_artifact).document->at("result"));
    CHECK(case_json(read_run(hot()).data) == hot().at(case_artifact).document->at("result"));
}

TEST_CASE("below it the answer stays, and its limit stands beside it") {
    Json document = example_with_oxides("from-chemistry");
    document["temperature"] = "300 C";
    const Artifacts warm = computed_from(document);
    const Json& law = sample_of(warm, comparison_artifact).at("temperature_limits").at("laws").at("dmt");
    CHECK(law.at("giordano2008").at("regime") == "elastic");
    CHECK_FALSE(has_note(warm, "lower bound"));
    CHECK(has_note(warm, "moduli, work of adhesion and damping are those at room temperature"));
    CHECK(comparison_text(warm.at(comparison_artifact).document->at("result"), 200) ==
          containing("stick below"));
    CHECK(sample_of(warm, critical_velocity_artifact) ==
          sample_of(from_chemistry(), critical_velocity_artifact));
}

TEST_CASE("without chemistry nothing is known above 600 C, and that is said") {
    Json document = test::with_one_sample(example_under("dmt"), {"dmt"});
    document["temperature"] = "900 C";
    const Artifacts unknown = computed_from(document);
    CHECK(has_note(unknown, "at 900 C nothing is known of the glass without its chemistry"));
    const Json& limits = sample_of(unknown, comparison_artifact).at("temperature_limits");
    CHECK_FALSE(limits.contains("laws"));
    document["temperature"] = "500 C";
    CHECK_FALSE(has_note(computed_from(document), "nothing is known"));
    for (const auto& [value, says] : std::initializer_list<std::pair<const char*, const char*>>{
             {R"("900 m")", "/temperature"},
             {R"({})", "no temperature is given"},
             {R"({"value": 900, "unit": "C", "wall": "300 C"})", "both given"},
             {R"({"particle": "-300 C"})", "/temperature/particle"}}) {
        CAPTURE(value);
        document["temperature"] = Json::parse(value);
        CHECK(input_error_of([&] { return computed_from(document, "modulus"); }) == containing(says));
    }
}

TEST_CASE("the scope of an answer: what the case states, and what it does not") {
    Case data;
    CHECK(scope_sentence(data) ==
          "Holds for normal impact on a flat wall, dry, at room temperature, smooth surfaces; not stated: "
          "temperature, roughness.");
    const auto stated = [](double value, Dimension dimension) {
        return Stated{.quantity = make_quantity(value, dimension)};
    };
    data.temperature.particle = stated(1173.15, Dimension::temperature);
    data.roughness = stated(2e-9, Dimension::length);
    CHECK(
        scope_sentence(data) ==
        "Holds for normal impact on a flat wall, dry, particle at 900 C, surfaces with a roughness of 2 nm.");
    std::swap(data.temperature.wall, data.temperature.particle);
    CHECK(scope_sentence(data) ==
          containing(
              "wall at 900 C, surfaces with a roughness of 2 nm; not stated: temperature of the particle."));
    data.temperature.particle = data.temperature.wall;
    data.roughness = stated(0, Dimension::length);
    CHECK(scope_sentence(data) == "Holds for normal impact on a flat wall, dry, at 900 C, smooth surfaces.");
}
