// SPDX-License-Identifier: GPL-3.0-or-later
// Which damping explains the impacts of a made-up laboratory, and which sizes stick.
#include "pipeline/run/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/dampings.hpp"
#include "pipeline/run/deposition.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/impact.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::relative_difference;
using test::Sandbox;

namespace {

const LawChoice dmt_choice{Law::named("dmt"), Detachment::zero_overlap};

ContactPair laboratory_sphere(double diameter) {
    const double radius = diameter / 2;
    return {.mass = 4.0 / 3.0 * std::numbers::pi * 2300 * radius * radius * radius,
            .effective_radius = radius,
            .contact_modulus = 90e9,
            .work_of_adhesion = 0.3};
}

SampleContact contact_of_laboratory(double diameter) {
    SampleContact contact{.name = fmt::format("{:g} um", 1e6 * diameter),
                          .contact_modulus = {make_quantity(90e9, Dimension::pressure)},
                          .radius = make_quantity(diameter / 2, Dimension::length),
                          .density = {make_quantity(2300, Dimension::density)},
                          .work_of_adhesion = {make_quantity(0.3, Dimension::energy_per_area)}};
    contact.mass = make_quantity(laboratory_sphere(diameter).mass, Dimension::mass);
    contact.pair = pair_of(contact);
    return contact;
}

double true_critical_velocity(const Damping& damping, double diameter) {
    return *critical_velocity({dmt_choice.law, dmt_choice.detachment, damping, laboratory_sphere(diameter)})
                .value;
}

/// Impacts of a size by a damping law; @p scatter standard deviation of e.
std::vector<Measurement> laboratory_impacts(const Damping& damping, double diameter, double scatter,
                                            unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const double critical = true_critical_velocity(damping, diameter);
    std::vector<Measurement> impacts;
    for (int i = 0; i < 40; ++i) {
        const double v = critical * std::pow(30.0, (i - 3) / 36.0);
        double e =
            restitution_of({dmt_choice.law, dmt_choice.detachment, damping, laboratory_sphere(diameter), v});
        if (e > 0) e = std::max(0.0, e + scatter * normal(random));
        impacts.push_back({.velocity = v, .rebound = e * v});
    }
    return impacts;
}

constexpr double laboratory_sizes[]{60e-6, 88e-6, 120e-6};

/// What velocities_by_size() needs of a laboratory without scatter.
struct SizesLaboratory {
    ContactResult contacts{};
    CriticalVelocityResult velocities{};
    std::vector<FittedDamping> dampings{};

    SizesLaboratory(const Damping& truth, std::vector<double> diameters, bool fitted = true) {
        std::vector<ImpactsOfSample> samples;
        for (const double diameter : diameters) {
            contacts.samples.push_back(contact_of_laboratory(diameter));
            const double critical = true_critical_velocity(truth, diameter);
            LawCriticalVelocity velocity{
                .damping = *damping_at_capture(diameter, critical),
                .velocity = VelocityEstimate{.value = critical,
                                             .interval = Bounds{0.98 * critical, 1.02 * critical}}};
            SampleCriticalVelocity sample{.name = contacts.samples.back().name};
            sample.laws.set(dmt_choice.law, velocity);
            velocities.samples.push_back(std::move(sample));
            samples.push_back({contacts.samples.back().pair, laboratory_impacts(truth, diameter, 0, 1)});
        }
        if (fitted) dampings = fit_damping_laws(dmt_choice.law, dmt_choice.detachment, samples);
    }

    /// The constant damping that captures up to that velocity.
    static std::optional<double> damping_at_capture(double diameter, double critical) {
        return damping_from_restitution({dmt_choice.law, dmt_choice.detachment, DampingLaw::constant,
                                         laboratory_sphere(diameter), critical, 0})
            .damping.coefficient;
    }
    [[nodiscard]] VelocitiesBySize by_size() const {
        return *velocities_by_size({dmt_choice, DampingLaw::constant, contacts, velocities, dampings});
    }
};

std::vector<SizeVelocity> rows_of(const VelocitiesBySize& sizes, SizeBasis basis) {
    std::vector<SizeVelocity> rows;
    for (const SizeVelocity& row : sizes.rows)
        if (row.basis == basis) rows.push_back(row);
    return rows;
}

/// A case of three sizes whose impacts scatter by 1 %.
Json laboratory_case(const Damping& truth) {
    Json samples = Json::array();
    unsigned seed = 1;
    for (const double diameter : laboratory_sizes) {
        std::vector<double> velocity;
        std::vector<double> restitution;
        for (const Measurement& impact : laboratory_impacts(truth, diameter, 0.01, seed++)) {
            velocity.push_back(impact.velocity);
            restitution.push_back(impact.restitution());
        }
        samples.push_back(
            {{"name", fmt::format("{:g} um", 1e6 * diameter)},
             {"diameter", fmt::format("{:g} um", 1e6 * diameter)},
             {"composition", {{"weight_fractions", {{"quartz", "60 %"}}}, {"amorphous", "remainder"}}},
             {"density", "2300 kg/m3"},
             {"contact_modulus", "90 GPa"},
             {"restitution", {{"velocity", velocity}, {"restitution", restitution}}}});
    }
    return {
        {"name", "three sizes"}, {"work_of_adhesion", "0.3 J/m2"}, {"laws", {"dmt"}}, {"samples", samples}};
}

}  // namespace

TEST_CASE("v_c of other sizes is exact by the damping law that made the impacts, and as measured between") {
    const Damping truth{DampingLaw::contact_radius, 1500};
    const VelocitiesBySize sizes = SizesLaboratory(truth, {60e-6, 88e-6, 120e-6}).by_size();
    CHECK(sizes.summary.constants == ConstantsFrom::impacts);
    const auto rows = rows_of(sizes, SizeBasis::contact_radius);
    CHECK(rows.size() >= 15);
    CHECK(rows.size() <= 25);
    CHECK(rows.front().diameter < 16e-6);
    CHECK(rows.back().diameter > 450e-6);
    for (const SizeVelocity& row : rows) {
        REQUIRE(row.velocity);
        CHECK(relative_difference(*row.velocity, true_critical_velocity(truth, row.diameter)) < 1e-9);
    }
    for (const double diameter : laboratory_sizes)
        CHECK(std::ranges::find(rows, diameter, &SizeVelocity::diameter) != rows.end());
    CHECK(rows_of(sizes, SizeBasis::constant).empty());  // the impacts reject it
    for (const SizeVelocity& row : rows_of(sizes, SizeBasis::measured)) {
        CHECK(row.diameter >= 60e-6);
        CHECK(row.diameter <= 120e-6);
        REQUIRE(row.interval);
        CHECK(*row.interval->lower < *row.velocity);
        CHECK(*row.interval->upper > *row.velocity);
        CHECK(relative_difference(*row.velocity, true_critical_velocity(truth, row.diameter)) < 0.02);
    }
    const auto undamped = rows_of(sizes, SizeBasis::adhesion);
    CHECK(undamped.size() == rows.size());
    for (const SizeVelocity& row : undamped)
        CHECK(row.verdict == SizeVerdict::never_captured);  // dmt that parts at zero overlap keeps its energy
    REQUIRE(sizes.summary.agreement);
    CHECK(sizes.summary.agreement->from <= 60e-6);
    CHECK(sizes.summary.agreement->to >= 120e-6);
}

TEST_CASE(
    "one size whose impacts no law explains: every assumption goes through its v_c, and none beyond is "
    "sure") {
    const Damping truth{DampingLaw::contact_radius, 1500};
    const VelocitiesBySize sizes = SizesLaboratory(truth, {88e-6}, false).by_size();
    CHECK(sizes.summary.constants == ConstantsFrom::capture);
    CHECK(!sizes.summary.power);
    const double measured = true_critical_velocity(truth, 88e-6);
    int assumptions = 0;
    for (const SizeVelocity& row : sizes.rows) {
        if (row.diameter != 88e-6 || row.basis == SizeBasis::adhesion) continue;
        REQUIRE(row.velocity);
        CHECK(relative_difference(*row.velocity, measured) < 1e-9);
        ++assumptions;
    }
    CHECK(assumptions >= 4);
    REQUIRE(sizes.summary.agreement);
    CHECK(sizes.summary.agreement->from > 40e-6);
    CHECK(sizes.summary.agreement->to < 200e-6);
    // At both ends the greatest of these velocities is all but twice the least, and no more.
    for (const double end : {sizes.summary.agreement->from, sizes.summary.agreement->to}) {
        double least = fastest_in_model;
        double greatest = 0;
        for (const auto& [law, coefficient] : sizes.summary.coefficients) {
            const double velocity = true_critical_velocity({named<DampingLaw>(law), coefficient.value}, end);
            least = std::min(least, velocity);
            greatest = std::max(greatest, velocity);
        }
        CHECK(greatest / least <= agreement_factor);
        CHECK(greatest / least > 0.9 * agreement_factor);
    }
    // Constant damping far below the measured size: no number that means nothing.
    const auto constant = rows_of(sizes, SizeBasis::constant);
    for (const SizeVelocity& row : constant)
        if (row.velocity) CHECK(*row.velocity <= fastest_in_model);
}

TEST_CASE("a rough sphere of another size has the adhesion that its own roughness leaves") {
    ContactResult contacts;
    constexpr double rms = 2e-9;
    constexpr double smooth = 0.5;
    const auto left = [&](double diameter) {
        return smooth * roughness_reduction(diameter / 2, {.rms = rms});
    };
    for (const double diameter : {60e-6, 120e-6}) {
        SampleContact contact = contact_of_laboratory(diameter);
        contact.roughness = Stated{make_quantity(rms, Dimension::length)};
        contact.work_of_adhesion.quantity.value = left(diameter);
        contacts.samples.push_back(contact);
    }
    CHECK_FALSE(kept_properties_finding(contacts));
    for (const double diameter : {5e-6, 60e-6, 85e-6, 120e-6, 400e-6}) {
        const SampleContact contact = contact_of_size(contacts, diameter);
        CHECK(relative_difference(contact.work_of_adhesion.value(), left(diameter)) < 1e-12);
        CHECK(contact.pair.work_of_adhesion == contact.work_of_adhesion.value());
    }
}

TEST_CASE("no velocity by size depends on the order of samples") {
    const Damping truth{DampingLaw::tsuji, 0.4};
    const VelocitiesBySize one = SizesLaboratory(truth, {60e-6, 88e-6, 120e-6}).by_size();
    const VelocitiesBySize other = SizesLaboratory(truth, {120e-6, 60e-6, 88e-6}).by_size();
    REQUIRE(one.rows.size() == other.rows.size());
    for (std::size_t i = 0; i < one.rows.size(); ++i) {
        CHECK(one.rows[i].diameter == other.rows[i].diameter);
        CHECK(one.rows[i].basis == other.rows[i].basis);
        CHECK(one.rows[i].velocity == other.rows[i].velocity);
        CHECK(one.rows[i].interval == other.rows[i].interval);
    }
}

TEST_CASE("of two samples of one size the geometric mean counts, with an interval that holds theirs") {
    SizesLaboratory laboratory({DampingLaw::tsuji, 0.4}, {60e-6, 60e-6, 120e-6});
    const VelocityEstimate first = *laboratory.velocities.samples[0].laws.find(dmt_choice.law)->velocity;
    LawCriticalVelocity second = *laboratory.velocities.samples[1].laws.find(dmt_choice.law);
    second.velocity =
        VelocityEstimate{.value = 4 * first.value, .interval = Bounds{3 * first.value, 5 * first.value}};
    laboratory.velocities.samples[1].laws = {};
    laboratory.velocities.samples[1].laws.set(dmt_choice.law, second);
    const auto rows = rows_of(laboratory.by_size(), SizeBasis::measured);
    REQUIRE(!rows.empty());
    CHECK(rows.front().diameter == 60e-6);
    CHECK(relative_difference(*rows.front().velocity, 2 * first.value) < 1e-12);
    CHECK(rows.front().interval == Bounds{first.interval->lower, 5 * first.value});
}

TEST_CASE("sizes that nearly coincide give no exponent of the damping") {
    const Damping truth{DampingLaw::tsuji, 0.4};
    CHECK(rows_of(SizesLaboratory(truth, {96e-6, 96.5e-6}).by_size(), SizeBasis::power_of_size).empty());
    CHECK_FALSE(rows_of(SizesLaboratory(truth, {88e-6, 96e-6}).by_size(), SizeBasis::power_of_size).empty());
}

TEST_CASE("a contact of a size between samples lies between theirs; at a sample it is that of the sample") {
    ContactResult contacts{{contact_of_laboratory(60e-6), contact_of_laboratory(120e-6)}};
    contacts.samples[1].density.quantity.value = 2000;
    contacts.samples[1].mass.value *= 2000.0 / 2300;
    contacts.samples[1].pair = pair_of(contacts.samples[1]);
    for (const SampleContact& sample : contacts.samples)
        CHECK(contact_of_size(contacts, 2 * sample.radius.value).pair.mass == sample.pair.mass);
    const double middle = std::sqrt(60e-6 * 120e-6);
    const SampleContact between = contact_of_size(contacts, middle);
    CHECK(relative_difference(between.density.value(), std::sqrt(2300.0 * 2000.0)) < 1e-12);
    CHECK(relative_difference(between.pair.mass,
                              laboratory_sphere(middle).mass * between.density.value() / 2300) < 1e-12);
    CHECK(contact_of_size(contacts, 10e-6).density.value() == 2300);
    CHECK(contact_of_size(contacts, 1e-3).density.value() == 2000);
}

TEST_CASE("a made-up laboratory of three sizes: the run finds its damping law and states which sizes stick") {
    const Damping truth{DampingLaw::contact_radius, 1500};
    Run run = read_run(test::computed_from(laboratory_case(truth)));
    const ComparisonResult comparison = run.comparison;
    REQUIRE(comparison.dampings);
    for (const ComparedDamping& damping : comparison.dampings->laws) {
        CAPTURE(name_of(damping.law));
        if (damping.law == truth.law) {
            CHECK(damping.evidence == DampingEvidence::explains);
            CHECK(damping.misfit == doctest::Approx(0.01).epsilon(0.2));
            CHECK(relative_difference(damping.constants[0].second.value, truth.coefficient) < 0.01);
        } else if (damping.law != DampingLaw::brach_dunn) {
            CHECK(damping.evidence == DampingEvidence::rejected);
        }
    }
    for (const SizeVelocity& row : comparison.by_size)
        if (row.basis == SizeBasis::contact_radius) {
            REQUIRE(row.interval);
            const double expected = true_critical_velocity(truth, row.diameter);
            CHECK(expected > 0.9 * *row.interval->lower);
            CHECK(expected < 1.1 * *row.interval->upper);
        }
    const std::string text = comparison_text(comparison, 80);
    CHECK(text == test::containing("agree within a factor of 2"));
    CHECK(text == test::containing("Which sizes stick, by dmt"));
    CHECK(text == test::containing("Which damping explains the impacts, by dmt"));
    for (const std::string& line : test::lines_of(text)) CHECK(line.size() <= 80);

    // Sizes between the rows are solved with the constant of the run.
    const auto constant = std::ranges::find(comparison.sizes->coefficients, "contact-radius",
                                            [](const auto& each) { return each.first; });
    REQUIRE(constant != comparison.sizes->coefficients.end());
    const Damping found{truth.law, constant->second.value};
    const DepositingAsh solved =
        ash_of_run(run, {{41.3e-6, 41.3e-6, 0.5}, {171e-6, 171e-6, 0.5}}, SizeBasis::contact_radius, 20);
    for (std::size_t i = 0; i < solved.classes.size(); ++i)
        CHECK(relative_difference(solved.assumptions.front().value[i],
                                  true_critical_velocity(found, solved.classes[i].diameter())) < 1e-6);

    // Between a size of which all is captured and one with a v_c the border is not known.
    SizeVelocity all{
        .diameter = 10e-6, .basis = SizeBasis::contact_radius, .verdict = SizeVerdict::always_captured};
    SizeVelocity some{.diameter = 20e-6, .basis = SizeBasis::contact_radius, .velocity = 1.5};
    some.interval = Bounds{1.2, 1.8};
    run.comparison.by_size = {all, some};
    const DepositingAsh ash =
        ash_of_run(run, {{15e-6, 18e-6, 0.5}, {20e-6, 20e-6, 0.5}}, SizeBasis::contact_radius, 20);
    const ClassVelocities& v = ash.assumptions.front();
    CHECK(v.value == std::vector<double>{1.5, 1.5});
    CHECK(v.lower == std::vector<double>{1.2, 1.2});
    CHECK(std::isinf(v.upper[0]));
    CHECK(v.upper[1] == 1.8);
}

TEST_CASE("a gas of another temperature than the contacts of the run is said") {
    Run run;
    const auto said = [&](double gas) {
        const auto finding = temperature_finding(run, Law::of<Dmt>(), gas);
        return finding ? finding->text : "";
    };
    CHECK(said(300).empty());
    CHECK(said(1173.15).find("at room temperature: softer") != std::string::npos);
    run.data.temperature.particle = Stated{.quantity = make_quantity(1173.15, Dimension::temperature)};
    CHECK(said(1173).empty());
    CHECK(said(1400).find("softer or sticky") != std::string::npos);
    CHECK(said(600).find("harder, less sticky") != std::string::npos);
}

TEST_CASE("the sentence on other sizes names what they rest on") {
    ComparisonResult result;
    CHECK(sizes_sentence(result).empty());
    result.sizes = SizeSummary{.law = dmt_choice.law, .measured = {88e-6, 88e-6}};
    CHECK(sizes_sentence(result) == test::containing("Beyond 88 um only a lower bound is known"));
    result.by_size = {{.diameter = 88e-6, .basis = SizeBasis::tsuji, .velocity = 1}};
    CHECK(sizes_sentence(result) == "Beyond 88 um v_c rests on one assumption on damping, tsuji.");
    result.by_size.push_back({.diameter = 88e-6, .basis = SizeBasis::constant, .velocity = 1});
    CHECK(
        sizes_sentence(result) ==
        "Beyond 88 um v_c rests on the damping assumed: tsuji, constant differ by more than a factor of 2.");
    result.sizes->agreement = SizeRange{60e-6, 130e-6};
    CHECK(sizes_sentence(result) ==
          "Beyond 88 um v_c rests on the damping assumed; from 60 to 130 um the assumptions on damping agree "
          "within a factor of 2 (tsuji, constant).");
    result.sizes->measured = {60e-6, 88e-6};
    CHECK(sizes_sentence(result) ==
          "From 60 to 130 um the assumptions on damping agree within a factor of 2 (tsuji, "
          "constant); beyond, v_c rests on which of them holds.");
}

TEST_CASE("the comparison alone, again, from its artifacts gives the same bytes") {
    const Sandbox sandbox;
    sandbox.write("case.json", laboratory_case({DampingLaw::contact_radius, 1500}).dump());
    test::succeeded(sandbox, "run case.json -o out --no-report");
    const Json before = sandbox.json("out/comparison.json").at("result");
    CHECK(!before.at("by_size").empty());
    CHECK(before.at("dampings").at("laws").size() == 5);
    test::succeeded(sandbox, "run -o out --from comparison --no-report");
    CHECK(sandbox.json("out/comparison.json").at("result").dump() == before.dump());
}
