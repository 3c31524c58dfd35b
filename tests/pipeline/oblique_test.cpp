// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts at an angle in a run whose case states a friction coefficient.
#include "solver/oblique/oblique.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "pipeline/document/results_json.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/run/stage.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::computed_from;
using test::containing;
using test::relative_difference;

namespace {

Json example_with_friction(const Json& friction) {
    Json document = test::with_one_sample(test::example_under("dmt"), {"dmt"});
    if (!friction.is_null()) document["friction"] = friction;
    return document;
}

const Artifacts& rubbing() {
    static const Artifacts artifacts =
        computed_from(example_with_friction(Json{{"value", 0.2}, {"origin", "assumed"}}));
    return artifacts;
}

const Json& oblique_result_of(const Artifacts& artifacts, std::string_view file) {
    return artifacts.at(file).document->at("result");
}

}  // namespace

TEST_CASE("comparison.json: rebounds at an angle with the friction of the case") {
    const Run run = read_run(rubbing());
    REQUIRE(run.comparison.samples[0].oblique);
    const auto& [law, friction, curves] = *run.comparison.samples[0].oblique;
    CHECK(law.name() == "dmt");
    CHECK(friction == 0.2);
    REQUIRE(curves.size() == 4);
    const double v_c = run.critical_velocity.samples[0].laws.find(law)->velocity->value;
    for (const ObliqueCurve& curve : curves) {
        CAPTURE(curve.multiple);
        CHECK(relative_difference(curve.velocity, curve.multiple * v_c) < 1e-15);
        CHECK(relative_difference(std::cos(curve.captured_from), 1 / curve.multiple) < 1e-12);
        REQUIRE(curve.rebounds.size() > 8);
        CHECK(std::abs(curve.velocity * std::cos(curve.rebounds.back().angle) / v_c - 1.001) < 1e-9);
        for (const auto& [angle, e, e_t, back] : curve.rebounds) {
            CHECK(e > 0);
            CHECK(relative_difference(std::tan(back), e_t / e * std::tan(angle)) < 1e-12);
            // Rolling leaves 5/7. Sliding takes mu (1 + e) v_n, and with adhesion more.
            const double slid = 1 - friction * (1 + e) / std::tan(angle);
            CHECK(e_t >= 5.0 / 7 - 1e-12);
            CHECK((e_t < 5.0 / 7 + 1e-12 || (e_t < slid && slid - e_t < 0.1)));
        }
    }
    // The damping is the measured one, along the curve e(v_in) of the model, not that of v_c.
    const ModelCurve& model = run.histories.samples[0].curves.find(law)->impacts;
    std::size_t compared = 0;
    for (const ObliqueCurve& curve : curves)
        for (const ObliqueRebound& rebound : curve.rebounds)
            for (std::size_t i = 1; i < model.size(); ++i) {
                const double normal = curve.velocity * std::cos(rebound.angle);
                if (normal < model[i - 1].velocity || normal > model[i].velocity) continue;
                CHECK(rebound.restitution > model[i - 1].restitution - 0.01);
                CHECK(rebound.restitution < model[i].restitution + 0.01);
                ++compared;
            }
    CHECK(compared > 20);
}

TEST_CASE("a friction changes no other number of a run, and is read back") {
    const Artifacts without = computed_from(example_with_friction(nullptr));
    for (const std::string_view file : report::report_artifacts()) {
        CAPTURE(file);
        if (file == comparison_artifact || file == case_artifact) continue;
        CHECK(oblique_result_of(rubbing(), file) == oblique_result_of(without, file));
    }
    Json comparison = oblique_result_of(rubbing(), comparison_artifact);
    CHECK(comparison["samples"][0].erase("oblique") == 1);
    CHECK(comparison == oblique_result_of(without, comparison_artifact));
    CHECK(result_json(read_run(rubbing()), comparison_artifact) ==
          oblique_result_of(rubbing(), comparison_artifact));
    CHECK(case_json(read_run(rubbing()).data) == oblique_result_of(rubbing(), case_artifact));
    CHECK_FALSE(report::has_oblique(report::RunData(read_run(without), "")));
    for (const auto& [value, says] : std::initializer_list<std::pair<Json, const char*>>{
             {-0.1, "/friction: friction is -0.1"}, {"0.2 m", "/friction"}, {"much", "/friction"}}) {
        CAPTURE(value);
        CHECK(test::input_error_of([&] { return computed_from(example_with_friction(value), "modulus"); }) ==
              containing(says));
    }
}

TEST_CASE("figure oblique draws the rebounds of comparison.json") {
    const report::RunData run(read_run(rubbing()), "");
    CHECK(report::has_oblique(run));
    const report::Figure figure = report::figure_named("oblique", run);
    REQUIRE(figure.panels.size() == 2);
    const auto& curves = run.samples()[0].comparison->oblique->curves;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto& series = std::get<report::XyPanel>(figure.panels[1]).series.at(i);
        REQUIRE(series.line.size() == curves[i].rebounds.size());
        CHECK(series.line.back().y == curves[i].rebounds.back().rebound_angle);
        rows += series.line.size();
    }
    CHECK(figure.numbers.rows.size() == rows);
    CHECK(figure.caption == containing("by DMT and a coefficient of friction of 0.2"));
}
