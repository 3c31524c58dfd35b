// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/spec.hpp"

#include <algorithm>
#include <atomic>
#include <numbers>
#include <set>
#include <thread>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "pipeline/app/sweep/block.hpp"
#include "pipeline/app/sweep/bytes.hpp"
#include "pipeline/app/sweep/workers.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/pipeline/sweep/specs.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::full_spec;
using test::least_spec;
using test::Sandbox;

namespace {

std::string refusal(const Json& spec) {
    return test::input_error_of([&] { return read_sweep_spec(spec.dump()); });
}

/// Edits that spoil a spec, and what has to be said of it.
struct Spoiled {
    const char* edits;
    const char* says;
};

const Spoiled spoiled_specs[]{
    {"- /sampling", R"("sampling" is missing)"},
    {R"(/sensitivty = ["restitution"])", R"(/sensitivty: unknown key, did you mean "sensitivity"?)"},
    {"/impact/laws = []", "/impact/laws: is a list of 0"},
    {R"(/impact/laws = ["dmtt"])", R"(/impact/laws/0: unknown name "dmtt", did you mean "dmt"?)"},
    {R"(/impact/laws = ["thornton-ning"])", R"(/impact: "yield_pressure" is missing)"},
    {R"(/impact/laws = ["sjkr"])",
     R"(/impact: cohesion_energy_density is missing, here or in /variables, for law "sjkr"; allowed: k_c)"},
    {R"(/impact/laws = ["sjkr"] ; /impact/cohesion_energy_density = "-1 J/m3")",
     "/impact/cohesion_energy_density: cohesion_energy_density is -1 Pa"},
    {R"(/impact/detachments = {"dmt": "pull-off"})", "/impact/detachments/dmt: "},
    {R"(/impact/detachments = {"hertz": "zero-force"})", "/impact/detachments/hertz: the law is not among"},
    {"- /impact/work_of_adhesion", R"(/impact: "work_of_adhesion" is missing)"},
    {"- /impact/density", R"(/impact: "density" is missing, and so is "mass")"},
    {R"(/impact/mass = "1 ug")", R"(/impact: both "density" and "mass")"},
    {"/impact/velocity = 1", "/impact/velocity: varies too, in /variables"},
    {R"(/impact/density = "1 um")", R"(/impact/density: the unit "um" is not one of density)"},
    {"/impact/contact_modulus = -1", "/impact/contact_modulus: contact_modulus is -1"},
    {"/variables = {}", "/variables: "},
    {"/variables/radus = {}", R"(/variables/radus: unknown key, did you mean "radius"?)"},
    {"/variables/velocity = {}", "/variables/velocity: does not say in one way how it varies"},
    {"/variables/velocity/values = [1]", "/variables/velocity: does not say in one way how it varies"},
    {R"(/variables/velocity/mode = "1 m/s")", R"(/variables/velocity/mode: means nothing for "uniform")"},
    {"- /variables/velocity/to", R"(/variables/velocity: "to" is missing)"},
    {R"(/variables/velocity/to = "0.1 m/s")",
     "/variables/velocity: its numbers are not in order; allowed: from < to"},
    {R"(/variables/velocity/from = "-1 m/s")", "/variables/velocity: reaches down to -1 m/s"},
    {R"(/variables/velocity = {"distribution": "normal", "mean": 2, "standard_deviation": 1})",
     "/variables/velocity: a normal distribution reaches below zero; allowed: "
     R"(a "minimum" that is positive)"},
    // Too small or too great to compute with, even where nothing is drawn or hardly ever.
    {R"(/variables/velocity = {"values": ["1 m/s", "1e-50 m/s"]})",
     "/variables/velocity: velocity is 1e-50 m/s; allowed: 1e-40 to 1e40"},
    {"/variables/radius/geometric_standard_deviation = 1e6", "/variables/radius: radius is "},
    {R"(/variables/velocity = {"distribution": "normal", "mean": 2, "standard_deviation": 5e-324, )"
     R"("minimum": 1})",
     "/variables/velocity/standard_deviation: is 5e-324 m/s; allowed: 0, or 1e-40 to 1e40 in SI"},
    {R"(/variables/velocity/from = "5e-324 m/s")", "/variables/velocity/from: is 5e-324 m/s"},
    {R"(/variables/velocity/to = "1e300 m/s")", "/variables/velocity/to: is 1e+300 m/s"},
    {R"(/variables/velocity = {"distribution": "normal", "mean": 2, "standard_deviation": 1, )"
     R"("minimum": 100})",
     "/variables/velocity: minimum and maximum cut off all of it"},
    {"/variables/radius/geometric_standard_deviation = 1",
     "/variables/radius/geometric_standard_deviation: is 1"},
    {R"(/variables/radius/geometric_standard_deviation = "150 %")",
     "/variables/radius/geometric_standard_deviation: is \"150 %\", the factor 1.5 or one more, 2.5"},
    {R"(/variables/velocity = "1 to 2 m/s")",
     R"(/variables/velocity: is "1 to 2 m/s"; allowed: an object: {"values": [...]})"},
    // Without meaning, though bounds cut it off.
    {R"(/variables/radius/geometric_standard_deviation = 1e300 ; /variables/radius/minimum = "1 um" ; )"
     R"(/variables/radius/maximum = "100 um")",
     "/variables/radius/geometric_standard_deviation: is 1e+300; allowed: a number above 1, at most 1e6"},
    // Of two readings: what nothing uses, and numbers with and without a unit side by side.
    {R"(/impact/density = "2300 +- 20 kg/m3")",
     "/impact/density: states an uncertainty, which nothing here uses; allowed: a value alone"},
    {R"(/variables/velocity/from = "0.5 +- 0.1 m/s")", "/variables/velocity/from: states an uncertainty"},
    {R"(/variables/velocity = {"values": ["1 +- 0.1 m/s", "2 m/s"]})",
     "/variables/velocity/values/0: states an uncertainty"},
    {R"(/variables/velocity = {"distribution": "uniform", "from": "50 cm/s", "to": 500})",
     "/variables/velocity/to: has no unit, beside a number that has one; allowed: a unit for each"},
    {R"(/variables/velocity = {"distribution": "normal", "mean": "2 m/s", "standard_deviation": 100, )"
     R"("minimum": 0.5})",
     "/variables/velocity/standard_deviation: has no unit, beside a number that has one"},
    {R"(/variables/velocity = {"values": [1, "2 m/s"]})", "/variables/velocity/values/0: has no unit"},
    {R"(/impact/angle = "90 deg")", "/impact/angle: angle is 1.57"},
    {R"(/variables/angle = {"distribution": "uniform", "from": 0, "to": "95 deg"})",
     "rad; allowed: 0 to below 90 degrees, from the normal"},
    {"/impact/angle = -0.1", "/impact/angle: angle is -0.1 rad"},
    {R"(- /sensitivity ; /sampling = {"method": "grid"})",
     "/variables/velocity: a grid takes no distribution"},
    {R"(/sampling = {"method": "grid", "samples": 10})", R"(/sampling/samples: means nothing for "grid")"},
    {"- /sampling/samples", R"(/sampling: "samples" is missing)"},
    {"/sampling/samples = 10.5", "/sampling/samples: is 10.5; allowed: a whole number"},
    {"/sampling/seed = -1", "/sampling/seed: is -1"},
    {R"(/sampling/method = "random" ; /sampling/sequence = "sobol")",
     R"(/sampling/sequence: means nothing for "random")"},
    {R"(/sampling = {"method": "random", "samples": 64, "seed": 1, "shifts": 4})",
     R"(/sampling/shifts: means nothing for "random"; allowed: quasi-random sampling)"},
    {"/sampling/samples = 8", R"(/sampling: "samples" is )"},
    {R"(/table = ["restitusion"])", R"(/table/0: unknown name "restitusion", did you mean "restitution"?)"},
    {R"(/sensitivity = ["contact_time"])", "/sensitivity/0: a captured particle has none"},
    {"/statistics/restitution/resolution = 0", "/statistics/restitution/resolution: is 0"},
    {"/statistics/restitution/resolution = 0.501",
     "/statistics/restitution/resolution: is 0.501; allowed: 1e-5 to 0.5"},
    {"/statistics/restitution/quantiles = [1.5]",
     "/statistics/restitution/quantiles/0: is 1.5; allowed: 0 to 1"},
};

const std::vector<std::string> divided_sweep{ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"};

std::vector<std::string> with_threads(int threads) {
    std::vector<std::string> command = divided_sweep;
    command.insert(command.end(), {"--threads", std::to_string(threads)});
    return command;
}

/// Every byte a sweep left.
auto left_by(const std::vector<std::string>& command, double samples) {
    const Sandbox sandbox;
    sandbox.write("spec.json", test::full_spec(samples).dump());
    const test::Ended ended = test::run(sandbox, command);
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    auto files = sandbox.everything();
    REQUIRE(files.size() == 4);  // and the spec
    CHECK(files[0].first == "out.h5");
    CHECK(files[1].first == "out.html");
    CHECK(files[2].first == "out.json");
    return files;
}

/// Restitutions with digits down to the last, so that any change of order shows.
ResultColumns formula(const ImpactModel& model, const ImpactColumns& impacts, const WantedResults& wanted) {
    ResultColumns results;
    for (std::size_t i = 0; i < impacts.velocity.size(); ++i) {
        const double x = impacts.velocity[i] * value_at(impacts.effective_radius, i) * 1e4 /
                         (1.0 + static_cast<double>(model.law.index()));
        results.restitution.push_back(std::max(0.0, 1 - 1 / (0.7 + x)));
        if (wanted.contact_time)
            results.contact_time.push_back(results.restitution.back() > 0 ? x : std::nan(""));
    }
    return results;
}

std::string tallied(const SweepPlan& plan, const std::vector<unsigned>& levels) {
    SweepProgress progress;
    std::string rows;
    for (const unsigned level : levels) {
        const Block block{progress.chunks, level};
        BlockResult result = compute_block(plan, formula, block);
        rows += result.rows;
        progress.add(block, std::move(result));
    }
    CHECK(progress.chunks == plan.chunks());
    return packed(std::move(progress)) + rows;
}

}  // namespace

TEST_CASE("every way to spoil a spec is told in one line, with its place") {
    REQUIRE(refusal(full_spec(1000)).empty());
    for (const Spoiled& each : spoiled_specs) {
        CAPTURE(each.edits);
        const std::string message = refusal(test::edited(full_spec(1000), each.edits));
        CAPTURE(message);
        CHECK(message == test::containing(each.says));
        CHECK(message != test::containing("\n"));
    }
}

TEST_CASE("sensitivity of a grid and a list of ten thousand equal entries are refused") {
    CHECK(refusal(test::edited(least_spec(), R"(/sensitivity = ["restitution"])")) ==
          test::containing("/sensitivity: needs points drawn at random"));
    Json spec = full_spec(1000);
    spec["table"] = std::vector<std::string>(10'000, "restitution");
    CHECK(refusal(spec) == test::containing("/table: is a list of 10000 entries; allowed: at most 64"));
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
    CHECK(spec.warnings[0] ==
          test::containing("work_of_adhesion: hertz does not use it, so it changes nothing"));
    json["impact"].erase("work_of_adhesion");
    json["impact"].update({{"damping_law", "tsuji"}, {"damping", 0}, {"damping_over_sizes", "same"}});
    CHECK(read_sweep_spec(json.dump()).spec.warnings ==
          std::vector<std::string>{"damping_law: there is no damping, so it changes nothing",
                                   "damping_over_sizes: there is no damping, so it changes nothing"});
}

TEST_CASE("one mass for radii that vary is doubted, with the densities it means") {
    Json json = full_spec(512);
    json["variables"]["radius"] = {{"values", {"25 um", "50 um"}}};
    json["impact"]["damping_law"] = "tsuji";
    json["impact"]["damping"] = 0.1;
    json["impact"].erase("density");
    json["impact"]["mass"] = "1 ug";
    const auto warnings = [&] { return read_sweep_spec(json.dump()).spec.warnings; };
    REQUIRE(warnings().size() == 1);
    // 1 ug over 4/3 pi r^3
    CHECK(warnings()[0] == test::containing("mass: stays the same while radius varies, so that densities go "
                                            "from 1910 kg/m3 to 1.528e+04 kg/m3"));
    json["variables"]["radius"] = {{"values", {"49 um", "50 um"}}};
    CHECK(warnings().empty());
}

TEST_CASE("one constant damping for sizes far apart is doubted, unless the spec states it") {
    Json json = full_spec(512);
    json["variables"]["radius"] = {{"values", {"20 um", "44 um"}}};
    json["impact"]["damping"] = "1e-4 kg/s";
    const auto warnings = [&] { return read_sweep_spec(json.dump()).spec.warnings; };
    REQUIRE(warnings().size() == 1);
    CHECK(warnings()[0] ==
          test::containing("damping: one coefficient for radii of 20 um to 44 um; with it v_c of small"));
    Json stated = json;
    Json partner = json;
    partner["variables"]["radius"] = {{"values", {"43 um", "44 um"}}};
    partner["impact"]["partner_density"] = "2600 kg/m3";
    partner["variables"]["partner_radius"] = {{"values", {"300 um", "30 um"}}};
    const auto of_partner = read_sweep_spec(partner.dump()).spec.warnings;
    REQUIRE(of_partner.size() == 1);
    CHECK(of_partner[0] == test::containing("damping: one coefficient for radii of 17.67 um to 38.37 um"));
    json["variables"]["radius"] = {{"values", {"44 um", "20 um", "44 um"}}};  // in any order
    REQUIRE(warnings().size() == 1);
    CHECK(warnings()[0] == test::containing("radii of 20 um to 44 um"));
    json["impact"]["damping_over_sizes"] = "same";
    CHECK(warnings().empty());
    json["impact"]["damping_over_sizes"] = {{"power", 1.5}, {"at_radius", "44 um"}};
    CHECK(warnings().empty());
    json = stated;
    json["impact"]["damping_law"] = "contact-radius";
    json["impact"]["damping"] = "1500 Pa s";
    CHECK(warnings().empty());
    json = stated;
    json["variables"]["radius"] = {{"values", {"43 um", "44 um"}}};
    CHECK(warnings().empty());
}

TEST_CASE("tails and masses that make no sense are doubted") {
    Json json = full_spec(512);
    const auto warnings = [&] {
        std::string all;
        for (const std::string& each : read_sweep_spec(json.dump()).spec.warnings) all += each + "\n";
        return all;
    };
    json["variables"]["radius"] = {
        {"distribution", "log-normal"}, {"median", "22 um"}, {"geometric_standard_deviation", 10}};
    CHECK(warnings() == test::containing("radius: one draw in 200 is beyond 8.2"));
    json["variables"]["radius"]["geometric_standard_deviation"] = 1.3;
    CHECK(warnings().find("draw in 200") == std::string::npos);
    json["variables"]["radius"] = {{"distribution", "uniform"}, {"from", "5 um"}, {"to", "100 um"}};
    json["impact"].erase("density");
    json["impact"]["mass"] = "0.82 ug";
    CHECK(warnings() == test::containing("mass: "));
    json["variables"]["radius"] = {{"distribution", "uniform"}, {"from", "48 um"}, {"to", "50 um"}};
    CHECK(warnings().find("mass: ") == std::string::npos);
}

TEST_CASE("captures with a v_c outside of the model are counted by law, of one size too") {
    Json json = full_spec(512);
    json["impact"]["damping_over_sizes"] = "same";
    const auto shares = [&] {
        std::vector<double> fractions;
        for (const OutsideShare& share : captures_outside_model(read_sweep_spec(json.dump()).spec))
            fractions.push_back(share.fraction);
        return fractions;
    };
    json["variables"]["radius"] = {{"values", {"5 um", "44 um"}}};
    for (const double share : shares()) CHECK((share > 0 && share <= 1));
    json["variables"]["radius"] = {{"values", {"5 um", "5.1 um"}}};
    CHECK(shares() == std::vector<double>{1, 1});
    const SweepSpec spec = read_sweep_spec(json.dump()).spec;
    CHECK(warnings_of_impacts(spec, {{.fraction = 0.25, .uncertainty = 0.021}, {}}).front() ==
          "dmt: of 25 % (± 2.1 %) of the captures v_c is above 500 m/s, outside the model; they, "
          "and shares that count them, are no result");
    json["variables"]["radius"] = {{"values", {"44 um", "45 um"}}};
    CHECK(shares() == std::vector<double>{0, 0});
}

TEST_CASE("where captures are rare their share outside of the model is the same for any seed") {
    Json json = full_spec(65536);
    json["impact"].update({{"damping_law", "contact-radius"}, {"damping", "2500 Pa s"}});
    json["variables"]["radius"].update({{"median", "22 um"}, {"minimum", "5 um"}});
    json["impact"]["laws"] = {"dmt"};
    json["sampling"]["method"] = "random";
    std::vector<OutsideShare> shares;
    for (const int seed : {1, 2}) {
        json["sampling"]["seed"] = seed;
        shares.push_back(captures_outside_model(read_sweep_spec(json.dump()).spec).front());
    }
    for (const auto& [fraction, uncertainty] : shares) {
        CHECK((0.1 < fraction && fraction < 0.9));
        CHECK((0.005 < uncertainty && uncertainty < 0.05));
        CHECK(std::abs(fraction - shares.front().fraction) < 4 * uncertainty);
    }
}

TEST_CASE("of a grid larger than what is drawn of it points from all of it are counted") {
    Json json = least_spec();
    Json dampings = Json::array();  // the last half stops whatever arrives
    for (int i = 0; i < 100; ++i) dampings.push_back(i < 50 ? 1e-4 * i : 10 + i);
    json["impact"].erase("damping");
    json["variables"] = {{"damping", {{"values", dampings}}},
                         {"velocity", {{"grid", "linear"}, {"from", 1}, {"to", 2}, {"points", 2000}}}};
    const SweepSpec spec = read_sweep_spec(json.dump()).spec;
    const OutsideShare share = captures_outside_model(spec).front();
    CHECK(share.fraction == 1);
    CHECK(share.uncertainty > 0);
    const auto fractions = capture_fractions(spec);
    CHECK(fractions.impacts == 65536);
    for (const report::CaptureShare& part : fractions.variables.front().curves.front().shares)
        CHECK(part.fraction == (part.value < 1 ? 0 : 1));
}

TEST_CASE("damping as a power of the radius is that of each impact") {
    Json json = least_spec();
    json["impact"].erase("radius");
    json["impact"]["damping"] = 0.01;
    json["impact"]["damping_over_sizes"] = {{"power", 2}, {"at_radius", "40 um"}};
    json["variables"]["radius"] = {{"values", {"20 um", "40 um", "80 um"}}};
    json["variables"].erase("velocity");
    json["impact"]["velocity"] = 2;
    const SweepSpec spec = read_sweep_spec(json.dump()).spec;
    const std::vector<std::vector<double>> radii{{20e-6, 40e-6, 80e-6}};
    const ImpactColumns impacts(spec, radii, 3);
    REQUIRE(impacts.damping.size() == 3);
    CHECK(impacts.damping[0] == doctest::Approx(0.0025).epsilon(1e-14));
    CHECK(impacts.damping[1] == doctest::Approx(0.01).epsilon(1e-14));
    CHECK(impacts.damping[2] == doctest::Approx(0.04).epsilon(1e-14));
    json["impact"]["damping_over_sizes"]["at_radius"] = "-1 um";
    CHECK_THROWS_AS(static_cast<void>(read_sweep_spec(json.dump())), InputError);
    json["impact"]["damping_over_sizes"] = "other";
    CHECK_THROWS_AS(static_cast<void>(read_sweep_spec(json.dump())), InputError);
}

TEST_CASE("at an angle the velocity normal to the wall counts") {
    Json json = least_spec();
    json["variables"] = {{"angle", {{"values", {0, "60 deg"}}}}};
    json["impact"]["velocity"] = 2;
    const ImpactColumns impacts(read_sweep_spec(json.dump()).spec, {{0, std::numbers::pi / 3}}, 2);
    REQUIRE(impacts.velocity.size() == 2);
    CHECK(impacts.velocity[0] == 2);
    CHECK(impacts.velocity[1] == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("every parameter of a law is an input of its own, by its name") {
    REQUIRE(law_parameters().size() > 1);
    for (const LawParameter& parameter : law_parameters()) {
        CAPTURE(parameter.name);
        CHECK(name_of(input_of(parameter)) == parameter.name);
    }
}

TEST_CASE("any number of threads and ranks leaves the same bytes, of tables and of integration" *
          doctest::test_suite("long")) {
    for (const double samples : {test::many_samples, test::many_samples / 10}) {
        CAPTURE(samples);
        const auto one = left_by(with_threads(1), samples);
        CHECK(one == left_by(with_threads(5), samples));
        const bool many = samples == test::many_samples;
        for (const int ranks : many ? std::vector{2} : std::vector{1, 3, 4}) {
            CAPTURE(ranks);
            CHECK(one == left_by(test::under_mpi(ranks, with_threads(ranks == 2 ? 2 : 1)), samples));
        }
    }
}

TEST_CASE("blocks of any level give the same bytes as chunk by chunk") {
    for (const char* method : {"random", "quasi-random"}) {
        Json spec = test::full_spec(14'000);
        spec["sampling"]["method"] = method;
        const SweepPlan plan(spec.dump());
        REQUIRE(plan.chunks() == 7);
        const std::string whole = tallied(plan, {0, 0, 0, 0, 0, 0, 0});
        CHECK(tallied(plan, {2, 1, 0}) == whole);
        CHECK(tallied(plan, {1, 0, 0, 1, 0}) == whole);
    }
}

TEST_CASE(
    "the progress of a sweep does not grow with the number of chunks, but for one node each time it "
    "doubles") {
    Json spec = test::full_spec(600'000);
    spec.erase("table");
    const SweepPlan plan(spec.dump());
    SweepProgress progress;
    std::size_t at_sixteen = 0;
    while (progress.chunks < 256) {
        const Block block{progress.chunks, 4};
        progress.add(block, compute_block(plan, formula, block));
        const std::size_t size = packed(progress).size();
        if (at_sixteen == 0) at_sixteen = size;
        CHECK(size < 5 * at_sixteen);
    }
}

TEST_CASE("points are numbered through chunks; the last one has what is left") {
    const SweepPlan plan(test::full_spec(14'000).dump());
    CHECK(plan.impacts_a_point() == 4);
    CHECK(plan.points_in(0) == 2048);
    CHECK(plan.points_in(6) == 14'000 - 6 * 2048);
    CHECK(plan.first_point(6) == 6 * 2048);
    CHECK(plan.rows() == 56'000);
    CHECK(plan.impacts() == 112'000);
    CHECK(plan.wanted(Law::named("hertz")).contact_time);
    CHECK_FALSE(plan.wanted(Law::named("hertz")).maximum_overlap);
}

TEST_CASE("every block that is assigned comes back once") {
    ThreadWorkers threads(2, [](const Block& block) { return std::to_string(block.first); });
    CHECK(threads.capacity() == 4);
    std::set<std::string> seen;
    std::uint64_t next = 0;
    while (seen.size() < 100) {
        while (next < 100 && threads.vacancies() > 0) threads.assign({next++, 0});
        if (const auto done = threads.finished(std::chrono::seconds(10))) {
            CHECK(done->bytes == std::to_string(done->block.first));
            CHECK(seen.insert(done->bytes).second);
        }
    }
    CHECK(threads.vacancies() == threads.capacity());
}

TEST_CASE("as many threads work at once as asked for, whatever the number of cores") {
    std::atomic<int> working = 0;
    std::atomic<int> most = 0;
    ThreadWorkers threads(3, [&](const Block&) {
        most = std::max(most.load(), ++working);
        for (int i = 0; i < 2000 && most < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        --working;
        return std::string();
    });
    for (std::uint64_t i = 0; i < 3; ++i) threads.assign({i, 0});
    for (int i = 0; i < 3; ++i) CHECK(threads.finished(std::chrono::seconds(20)).has_value());
    CHECK(most == 3);
}

TEST_CASE("what the work throws comes out; patience ends") {
    ThreadWorkers threads(1, [](const Block& block) -> std::string {
        if (block.first == 1) throw ConvergenceError("block 1");
        return {};
    });
    CHECK_FALSE(threads.finished(std::chrono::milliseconds(1)).has_value());
    threads.assign({1, 0});
    CHECK_THROWS_WITH_AS(static_cast<void>(threads.finished(std::chrono::seconds(10))), "block 1",
                         ConvergenceError);
}

TEST_CASE("the share of the cores is one thread at least") {
    CHECK(default_threads(1) >= 1);
    CHECK(default_threads(1000) == 1);
}
