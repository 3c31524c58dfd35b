// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "pipeline/document/results_json.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/inference/measured_damping.hpp"
#include "solver/motion/impact.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::computed_from;
using test::relative_difference;
using test::Sandbox;

namespace {

const Json& result(const Artifacts& artifacts, std::string_view file) {
    return artifacts.at(file).document->at("result").at("samples")[0];
}

bool mentions(const Artifacts& artifacts, std::string_view file, const std::string& words) {
    for (const Json& warning : artifacts.at(file).document->at("warnings"))
        if (warning.get<std::string>().find(words) != std::string::npos) return true;
    return false;
}

/// The example with one sample of known contact, under one law.
Json one_sample(const std::string& law) {
    Json document = test::example_case();
    document["laws"] = {law};
    document["samples"].erase(0);
    document.erase("camera");
    document["uncertainty"] = {{"samples", 64}, {"replicates", 4}};
    document["samples"][0].erase("restitution");
    document["samples"][0]["density"] = {{"value", 2300}, {"unit", "kg/m3"}, {"standard_uncertainty", 20}};
    document["work_of_adhesion"] = {{"value", 0.3}, {"unit", "J/m2"}, {"standard_uncertainty", 0.01}};
    return document;
}

/// A laboratory whose damping is eta = 0.005 e^2 - 0.0125 e + 0.0142 by DMT. Its rebounds are off by a fixed
/// pattern of half an uncertainty and less, so that nothing depends on chance.
struct Laboratory {
    static constexpr double a = 0.005;
    static constexpr double b = -0.0125;
    static constexpr double c = 0.0142;
    Json document = one_sample("dmt");
    double critical_velocity = 0;

    explicit Laboratory(double uncertainty) {
        const Law dmt = Law::of<Dmt>();
        const ContactPair contact = read_run(computed_from(document, "contact")).contact.samples.front().pair;
        critical_velocity =
            *ashimpact::critical_velocity({dmt, dmt.default_detachment(), {DampingLaw::constant, c}, contact})
                 .value;
        std::vector<double> velocity{0.85 * critical_velocity, 0.95 * critical_velocity};
        std::vector<double> rebound{0, 0};
        for (int i = 0; i < 20; ++i) {
            const double e = 0.04 + 0.02 * i;
            velocity.push_back(reconstructed_velocity(
                {dmt, dmt.default_detachment(), contact, DampingPolynomial::quadratic(a, b, c)}, e));
            rebound.push_back(e * velocity.back() + 0.1 * uncertainty * (i * 7 % 11 - 5));
        }
        Json& data = document["samples"][0]["restitution"];
        data["velocity"] = velocity;
        data["rebound_velocity"] = rebound;
        if (uncertainty == 0) return;
        data["velocity_uncertainty"] = std::vector<double>(velocity.size(), uncertainty);
        data["rebound_uncertainty"] = std::vector<double>(velocity.size(), uncertainty);
    }
};

/// What a run makes of a laboratory's impacts: computed once.
const Artifacts& of_laboratory() {
    static const Artifacts artifacts = computed_from(Laboratory(0.005).document);
    return artifacts;
}

double estimated(const Artifacts& artifacts) {
    return result(artifacts, "7-critical-velocity.json")["dmt"]["critical_velocity"]["value"].get<double>();
}

}  // namespace

TEST_CASE("a laboratory gets its damping and critical velocity back, within the intervals") {
    const Laboratory laboratory(0.005);
    const Artifacts& artifacts = of_laboratory();

    const Json& damping = result(artifacts, "5-damping.json")["dmt"];
    const auto& reach = damping["greatest_restitution"]["values"];
    REQUIRE(damping["damping_uncertainty"]["values"].size() == 20);
    REQUIRE(reach.size() == 20);
    for (std::size_t i = 0; i < 20; ++i) {
        const double e = damping["restitution"]["values"][i];
        CHECK(reach[i].get<double>() > e);
        CHECK(damping["damping_uncertainty"]["values"][i].get<double>() > 0);
        const ImpactResult again =
            solve_impact({Law::of<Dmt>(),
                          Detachment::zero_overlap,
                          {DampingLaw::constant, damping["damping"]["values"][i].get<double>()},
                          read_run(artifacts).contact.samples.front().pair,
                          damping["velocity"]["values"][i].get<double>()});
        CHECK(std::abs(again.restitution - e) < 1e-5);
    }
    CHECK(damping["capturing_damping"]["values"].size() == 2);
    CHECK(damping["outliers"].empty());
    CHECK(damping["rising_branch"]["falls_beyond"] == false);

    const Json& fit = result(artifacts, "6-fit.json")["dmt"];
    CHECK(fit["method"] == "closest-curve");
    CHECK(relative_difference(fit["c"]["value"].get<double>(), Laboratory::c) < 2e-2);
    const Json& interval = fit["extrapolated"]["critical_damping_interval"];
    CHECK(interval["lower"]["value"].get<double>() < Laboratory::c);
    CHECK(interval["upper"]["value"].get<double>() > Laboratory::c);
    CHECK(fit["extrapolated"]["residuals"]["deleted_distance"]["values"].size() == 20);
    CHECK(fit["direct"]["captures"] == 2);
    CHECK(fit["covariance"]["values"][2][2].get<double>() ==
          fit["extrapolated"]["covariance"]["values"][0][0].get<double>());

    const Json& velocity = result(artifacts, "7-critical-velocity.json")["dmt"];
    CHECK(velocity["interval"]["lower"]["value"].get<double>() < laboratory.critical_velocity);
    CHECK(velocity["interval"]["upper"]["value"].get<double>() > laboratory.critical_velocity);
    CHECK_FALSE(velocity.contains("check"));  // captures and rebounds of the same impacts judge nothing
    CHECK(velocity["critical_velocity"]["interval"] == velocity["interval"]);
    CHECK(velocity["critical_velocity"]["method"].get<std::string>().starts_with("posterior of v_c"));
    const Json& extrapolated = velocity["extrapolated"];
    const auto& influences = extrapolated["uncertainty"]["influences"];
    for (const char* factor : {"damping fit", "density", "work of adhesion"})
        CHECK_MESSAGE(std::any_of(influences.begin(), influences.end(),
                                  [&](const Json& one) { return one["factor"] == factor; }),
                      factor);
    CHECK(std::is_sorted(influences.begin(), influences.end(), [](const Json& x, const Json& y) {
        return x["total"].get<double>() > y["total"].get<double>();
    }));
    CHECK(extrapolated["uncertainty"]["damping"] == "reread");
    const auto& exact = extrapolated["uncertainty"]["taken_as_exact"];
    CHECK(std::find(exact.begin(), exact.end(), "diameter") != exact.end());

    // The modulus is uncertain by its phases, each an input of its own.
    for (const char* phase : {"quartz", "mullite", "hematite"})
        CHECK(extrapolated["uncertainty"]["relative_standard_uncertainties"].contains(
            std::string("Young's modulus of ") + phase));

    const Json& measured = result(artifacts, "7-critical-velocity.json")["measured"];
    CHECK(measured["fastest_capture"]["value"].get<double>() < laboratory.critical_velocity);
    CHECK(measured["slowest_rebound"]["value"].get<double>() > laboratory.critical_velocity);
    const Json& comparison = result(artifacts, "comparison.json");
    CHECK(comparison["interval"]["dmt"] == velocity["interval"]);
    CHECK(comparison["dynamic_critical_velocity"]["dmt"] == velocity["critical_velocity"]);
    CHECK(comparison["extrapolated_critical_velocity"]["dmt"]["value"] ==
          velocity["extrapolated"]["critical_velocity"]["value"]);
    CHECK(comparison["measured_critical_velocity"]["origin"] == "measured");
}

TEST_CASE("impacts given twice count twice") {
    Laboratory laboratory(0.005);
    Json& data = laboratory.document["samples"][0]["restitution"];
    const Json once = data;
    for (const auto& [key, column] : once.items())
        for (const Json& value : column)  // the same rows again would be refused
            data[key].push_back(value.is_number() ? Json(value.get<double>() * (1 + 1e-9)) : value);
    const Artifacts doubled = computed_from(laboratory.document, "critical-velocity");
    // The estimate of v_c moves by part of its uncertainty: its density is skewed, the less the narrower it
    // is.
    const Json& headline = result(doubled, "7-critical-velocity.json")["dmt"]["critical_velocity"];
    CHECK(std::abs(estimated(of_laboratory()) - estimated(doubled)) <
          headline["standard_uncertainty"].get<double>());
    const auto deviation = [](const Artifacts& artifacts) {
        return result(artifacts, "6-fit.json")["dmt"]["critical_damping"]["standard_uncertainty"]
            .get<double>();
    };
    CHECK(relative_difference(deviation(of_laboratory()) / deviation(doubled), std::sqrt(2.0)) < 0.1);
}

TEST_CASE("a run answers as `damping --impacts` does, also of outliers without a capture") {
    Json document = one_sample("dmt");
    Json& data = document["samples"][0]["restitution"];
    data["velocity"] = {2.8, 1.0, 3.9, 8.8, 8.3, 2.1, 6.1, 0.97};
    data["rebound_velocity"] = {0.64, 0.72, 1.2, 4.0, 3.7, 0.29, 4.0, 0.67};
    data["velocity_uncertainty"] = data["rebound_uncertainty"] = std::vector<double>(8, 0.03);
    const Artifacts artifacts = computed_from(document);
    const Run run = read_run(artifacts);
    const MeasuredDamping own =
        analyse_impacts(Law::of<Dmt>(), Detachment::zero_overlap, run.contact.samples[0].pair,
                        run.restitution.samples[0].series.front().impacts);
    REQUIRE(own.estimate);
    const Interval& expected = own.estimate->curve.critical_velocity;
    const VelocityEstimate reported = run.comparison.samples[0].reported->velocity.value();
    CHECK(relative_difference(reported.value, expected.value) < 1e-4);
    CHECK(relative_difference(*reported.interval->lower, *expected.lower) < 1e-4);
    CHECK(relative_difference(*reported.interval->upper, *expected.upper) < 1e-4);
    CHECK(result(artifacts, "7-critical-velocity.json")["dmt"]["extrapolated"].is_null());
}

TEST_CASE("data that show nothing get a reason and no number") {
    struct Poor {
        const char* what;
        std::vector<double> velocity;
        std::vector<double> rebound;
        const char* file;
        const char* says;
    };
    for (const Poor& poor : {
             Poor{"all captured", {0.4, 0.5, 0.6}, {0, 0, 0}, "5-damping.json", "no rebound"},
             Poor{"one rebound", {1.0}, {0.2}, "6-fit.json", "1 distinct restitutions"},
             Poor{"one point many times",
                  {1.0, 1.0, 1.0, 1.0, 1.0},
                  {0.2, 0.2, 0.2, 0.2, 0.2},
                  "6-fit.json",
                  "1 distinct restitutions"},
         }) {
        CAPTURE(poor.what);
        Json document = one_sample("dmt");
        Json& data = document["samples"][0]["restitution"];
        data["velocity"] = poor.velocity;
        data["rebound_velocity"] = poor.rebound;
        const Artifacts artifacts = computed_from(document);
        CHECK(mentions(artifacts, poor.file, poor.says));
        CHECK_FALSE(result(artifacts, "6-fit.json").contains("dmt"));
        CHECK_FALSE(result(artifacts, "7-critical-velocity.json").contains("dmt"));
        CHECK(result(artifacts, "comparison.json")["dynamic_critical_velocity"]["dmt"].is_null());
    }
}

TEST_CASE("too few rebounds to extrapolate: the estimate alone gives c and v_c") {
    Laboratory laboratory(0.005);
    laboratory.document["fit"] = {{"order", 6}};
    Json& data = laboratory.document["samples"][0]["restitution"];
    for (const char* key : {"velocity", "rebound_velocity", "velocity_uncertainty", "rebound_uncertainty"}) {
        const Json all = data[key];
        data[key] = {all[0], all[1], all[2], all[7], all[11], all[16], all[21]};  // two of them captures
    }
    const Artifacts artifacts = computed_from(laboratory.document);
    CHECK(mentions(artifacts, "6-fit.json", "dmt: no extrapolated fit: 5 distinct restitutions"));
    CHECK(mentions(artifacts, "6-fit.json",
                   "dmt: nothing can be extrapolated: c is the critical damping of the estimate"));
    const Json& fit = result(artifacts, "6-fit.json")["dmt"];
    CHECK_FALSE(fit.contains("extrapolated"));
    CHECK_FALSE(fit.contains("comparison"));
    CHECK(fit["method"] == "estimate");
    const Json& direct = fit["direct"];
    CHECK(direct["captures"] == 2);
    const double c = fit["c"]["value"];
    CHECK(direct["critical_damping_interval"]["lower"]["value"].get<double>() < c);
    CHECK(direct["critical_damping_interval"]["upper"]["value"].get<double>() > c);
    CHECK(relative_difference(c, Laboratory::c) < 5e-2);

    const Json& velocity = result(artifacts, "7-critical-velocity.json")["dmt"];
    CHECK(velocity["interval"]["lower"]["value"].get<double>() < laboratory.critical_velocity);
    CHECK(velocity["interval"]["upper"]["value"].get<double>() > laboratory.critical_velocity);
    CHECK(velocity["extrapolated"].is_null());
}

TEST_CASE("a law that yields is fitted by least squares, and its velocity gets a note for an interval") {
    const Laboratory laboratory(0.005);
    Json document = one_sample("thornton-ning");
    document["samples"][0]["yield_pressure"] = "30 GPa";
    Json& data = document["samples"][0]["restitution"];
    for (const auto& [key, column] : laboratory.document["samples"][0]["restitution"].items())
        data[key] = std::vector<Json>(column.begin() + 4, column.end());  // the rebounds
    const Artifacts artifacts = computed_from(document);
    const Json& fit = result(artifacts, "6-fit.json")["thornton-ning"];
    CHECK(fit["method"] == "least-squares");
    CHECK(fit["critical_damping"]["value"].get<double>() > 0);
    CHECK_FALSE(fit.contains("extrapolated"));
    CHECK_FALSE(fit.contains("direct"));
    const Json& velocity = result(artifacts, "7-critical-velocity.json")["thornton-ning"];
    const std::string note = "no interval: that takes constant damping and a contact that does not yield";
    CHECK(velocity["interval_note"] == note);
    CHECK_FALSE(velocity.contains("interval"));
    CHECK(velocity["critical_velocity"]["value"].get<double>() > 0);
    CHECK(mentions(artifacts, "7-critical-velocity.json", "thornton-ning: " + note));
}

TEST_CASE("a contact that yields at once leaves no number that is not finite" * doctest::test_suite("long")) {
    Json document = test::example_under("thornton-ning");
    for (Json& sample : document["samples"]) sample["yield_pressure"] = "0.3 GPa";
    CHECK_NOTHROW(static_cast<void>(computed_from(document)));
}

TEST_CASE("captures contradict a v_c by other damping, whatever v_c the case reports") {
    Json document = one_sample("jkr");
    document["damping_law"] = "tsuji";
    Json& sample = document["samples"][0];
    sample["restitution"] = {
        {"velocity", {1.40, 1.55, 1.72, 1.81, 1.95, 2.10, 2.31, 2.55, 2.90, 3.35, 3.90, 4.60}},
        {"rebound_velocity", {0.0, 0.0, 0.12, 0.22, 0.33, 0.44, 0.57, 0.73, 0.93, 1.20, 1.51, 1.84}}};
    const auto contradicts = [](const Artifacts& artifacts) {
        return mentions(artifacts, "7-critical-velocity.json",
                        "contradicts the captures and rebounds, by which it is about 1.6");
    };
    CHECK(contradicts(computed_from(document)));
    sample["measured_critical_velocity"] = {{"value", 1.2}, {"unit", "m/s"}, {"standard_uncertainty", 0.3}};
    CHECK(contradicts(computed_from(document)));
}

TEST_CASE("impacts without a capture leave v_c open below, whatever the damping law") {
    Json document = one_sample("jkr");
    document["damping_law"] = "tsuji";
    Json& data = document["samples"][0]["restitution"];
    data = {{"velocity", {1.72, 1.81, 1.95, 2.10, 2.31, 2.55, 2.90, 3.35, 3.90, 4.60}},
            {"rebound_velocity", {0.12, 0.22, 0.33, 0.44, 0.57, 0.73, 0.93, 1.20, 1.51, 1.84}}};
    const auto says_so = [&] {
        return mentions(computed_from(document), "7-critical-velocity.json", "no impact was captured");
    };
    CHECK(says_so());
    data["velocity"].push_back(1.5);
    data["rebound_velocity"].push_back(0.0);
    CHECK_FALSE(says_so());
}

TEST_CASE("impacts that the columns of a case hold twice are refused") {
    Json document = one_sample("jkr");
    Json& data = document["samples"][0]["restitution"];
    std::vector<double> velocity{1.72, 1.81, 1.95, 2.11, 2.31, 2.55, 2.93, 3.35, 3.94, 4.61};
    std::vector<double> rebound{0.12, 0.22, 0.33, 0.44, 0.57, 0.73, 0.93, 1.21, 1.51, 1.84};
    data = {{"velocity", velocity}, {"rebound_velocity", rebound}};
    CHECK_NOTHROW(static_cast<void>(computed_from(document, "restitution")));
    for (std::size_t i = 0; i < 10; ++i) {
        data["velocity"].push_back(velocity[i]);
        data["rebound_velocity"].push_back(rebound[i]);
    }
    std::string refusal;
    try {
        static_cast<void>(computed_from(document, "restitution"));
    } catch (const InputError& error) {
        refusal = error.what();
    }
    CHECK(refusal ==
          test::containing("/restitution: value 11: the rows to value 20 repeat those from value 1 to 10"));
}

TEST_CASE("a restitution that falls from the first rebound on is no rising branch") {
    Json document = one_sample("dmt");
    Json& data = document["samples"][0]["restitution"];
    for (int i = 0; i < 12; ++i) {
        data["velocity"].push_back(2.0 + 0.5 * i);
        data["restitution"].push_back(0.8 - 0.05 * i);
    }
    data["velocity_uncertainty"] = std::vector<double>(12, 0.01);
    data["rebound_uncertainty"] = std::vector<double>(12, 0.01);
    const Artifacts artifacts = computed_from(document);
    CHECK(mentions(artifacts, "5-damping.json", "there is no rising branch"));
    CHECK(result(artifacts, "5-damping.json")["dmt"]["rising_branch"].is_null());
    // The estimate takes every impact, as the command `damping` does; nothing is extrapolated.
    const Json& fit = result(artifacts, "6-fit.json")["dmt"];
    CHECK(fit["method"] == "estimate");
    CHECK_FALSE(fit.contains("extrapolated"));
    CHECK(result(artifacts, "7-critical-velocity.json")["dmt"]["critical_velocity"]["value"] < 2.0);
}

TEST_CASE("a rebound faster than the impact is left out with a reason where uncertainties explain it") {
    Laboratory laboratory(0.005);
    Json& data = laboratory.document["samples"][0]["restitution"];
    data["velocity"].push_back(3.0);
    data["rebound_velocity"].push_back(3.01);
    data["velocity_uncertainty"].push_back(0.005);
    data["rebound_uncertainty"].push_back(0.005);
    const Artifacts artifacts = computed_from(laboratory.document, "damping");
    const Json& unreachable = result(artifacts, "5-damping.json")["dmt"]["unreachable"];
    REQUIRE(unreachable.size() == 1);
    CHECK(unreachable[0]["number"] == 23);
    CHECK(unreachable[0]["reason"].get<std::string>() == test::containing("without any damping"));
}

TEST_CASE(
    "a rebound faster than its impact is taken where uncertainties explain it, with their correlation") {
    Laboratory laboratory(0.005);
    Json& data = laboratory.document["samples"][0]["restitution"];
    const std::size_t last = data["velocity"].size() - 1;
    // Three standard uncertainties of the difference: 21 mm/s, and with correlation 7 or 29 mm/s.
    data["rebound_velocity"][last] = data["velocity"][last].get<double>() + 0.015;
    const auto is_taken = [&] {
        try {
            static_cast<void>(computed_from(laboratory.document, "contact"));
            return true;
        } catch (const InputError&) {
            return false;
        }
    };
    CHECK(is_taken());
    data["velocity_correlation"] = std::vector<double>(last + 1, 0.9);
    CHECK_FALSE(is_taken());
    data["velocity_correlation"] = std::vector<double>(last + 1, -0.9);
    CHECK(is_taken());
    data["rebound_velocity"][last] = data["velocity"][last].get<double>() + 0.035;
    CHECK_FALSE(is_taken());
}

TEST_CASE("7-critical-velocity judges the regime, and a law out of its range is warned of") {
    Json document = one_sample("dmt");
    document["laws"] = {"dmt", "jkr"};
    document["samples"][0]["restitution"] = {
        {"reconstruct",
         {{"from", 0.05},
          {"to", 0.4},
          {"points", 5},
          {"reference_law", "dmt"},
          {"damping_fits", {{"dmt", {{"a", Laboratory::a}, {"b", Laboratory::b}, {"c", Laboratory::c}}}}}}}};
    const Artifacts hard = computed_from(document);
    const Json& regime = result(hard, "7-critical-velocity.json")["dmt"]["regime"];
    CHECK(regime["tabor_parameter"].get<double>() > 0.1);
    CHECK(regime["adhesion"] == "between");
    CHECK(regime["yield_velocity"].is_null());
    const double eta = result(hard, "6-fit.json")["dmt"]["critical_damping"]["value"];
    const double v = result(hard, "7-critical-velocity.json")["dmt"]["critical_velocity"]["value"];
    const Json& contact = result(hard, "2-contact.json");
    const double mass = contact["mass"]["value"];
    const double k = 4.0 / 3.0 * contact["contact_modulus"]["value"].get<double>() *
                     std::sqrt(contact["effective_radius"]["value"].get<double>());
    CHECK(relative_difference(regime["damping_number"].get<double>(),
                              eta * std::pow(mass, -0.6) * std::pow(k, -0.4) * std::pow(v, -0.2)) < 1e-12);

    document["work_of_adhesion"] = "30 J/m2";  // of something very sticky
    document["samples"][0]["restitution"]["reconstruct"]["to"] = 0.2;
    const Artifacts soft = computed_from(document);
    CHECK(mentions(soft, "7-critical-velocity.json", "dmt: Tabor parameter"));
}
