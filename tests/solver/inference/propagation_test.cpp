// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/propagation.hpp"

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/surrogate/cohesive_velocity_map.hpp"
#include "tests/solver/inference/ash_laboratory.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

const Influence& influence_of(const Propagation& propagation, const std::string& factor) {
    for (const Influence& influence : propagation.influences)
        if (influence.factor == factor) return influence;
    throw std::runtime_error("no factor " + factor);
}

}  // namespace

TEST_CASE("a linear model: standard deviation, quantiles and indices are known") {
    const std::vector<RandomInput> inputs{{"a", 2.0, 0.3}, {"b", 1.0, 0.4}, {.name = "exact", .value = 5.0}};
    const Propagation result =
        propagate(inputs, [](std::span<const double> x) { return std::optional(x[0] + x[1] + x[2]); },
                  {.samples = 512, .replicates = 8});
    CHECK(result.interval.value == 8.0);
    CHECK(relative_difference(result.interval.standard_uncertainty, 0.5) < 0.01);
    CHECK(std::abs(*result.interval.lower - (8.0 - 0.98)) < 0.02);
    CHECK(std::abs(*result.interval.upper - (8.0 + 0.98)) < 0.02);
    CHECK(result.influences.size() == 2);
    CHECK(result.influences.front().factor == "b");
    CHECK(result.undefined == 0);
    for (const auto& [factor, share] : {std::pair{"a", 0.36}, std::pair{"b", 0.64}}) {
        const Influence& influence = influence_of(result, factor);
        CHECK(std::abs(influence.first.value - share) < 5.0 * influence.first.standard_error + 0.002);
        CHECK(std::abs(influence.total.value - share) < 5.0 * influence.total.standard_error + 0.002);
    }
}

TEST_CASE("inputs of one factor are ranked together; shapes have the stated uncertainty") {
    const Propagation result =
        propagate({{.name = "a", .value = 1.0, .standard_uncertainty = 0.1, .factor = "both"},
                   {.name = "b",
                    .value = 1.0,
                    .standard_uncertainty = 0.1,
                    .distribution = lognormal_around,
                    .factor = "both"},
                   {.name = "c", .value = 1.0, .standard_uncertainty = 0.2}},
                  [](std::span<const double> x) { return std::optional(x[0] + x[1] + x[2]); });
    CHECK(result.influences.size() == 2);
    CHECK(std::abs(influence_of(result, "c").total.value - 2.0 / 3.0) < 0.03);
    CHECK(relative_difference(result.interval.standard_uncertainty, std::sqrt(0.06)) < 0.02);
}

TEST_CASE("samples without a result are counted, and refused where they are nearly all") {
    const auto half = [](std::span<const double> x) {
        return x[0] >= 0.0 ? std::optional(x[0]) : std::nullopt;
    };
    const Propagation result = propagate({{"a", 0.0, 1.0}}, half);
    CHECK(result.undefined > 0);
    CHECK(result.interval.lower.value() >= 0.0);
    const auto refused = [&](const RandomInput& input) {
        return input_error_of([&] { return propagate({input}, half); });
    };
    CHECK(contains(refused({"a", -1.0, 1.0}), "does not exist at the values"));
    CHECK(contains(refused({"a", 1.0, 0.0}), "no input is uncertain"));
    CHECK(contains(refused({"a", 1.0, -2.0}), "not finite or has a negative uncertainty"));
}

TEST_CASE("Hertz: v_c goes with eta^5/(m^3 k^2), so relative uncertainties are known") {
    const RandomContact contact =
        random_contact({.diameter = {"diameter", 96e-6},
                        .density = {"density", 2158.5, 0.01 * 2158.5},
                        .work_of_adhesion = {"work of adhesion", 0.2959},
                        .contact_modulus = RandomInput{"contact modulus", 90e9, 1.8e9}});
    const RandomInput damping{.name = "critical damping", .value = 0.0155, .standard_uncertainty = 0.000155};
    const Propagation result =
        propagate_critical_velocity(Law::of<Hertz>(), Detachment::zero_overlap, damping, contact);
    // 5 x 1 %, 3 x 1 %, 2 x 2 %.
    const double relative = std::sqrt(25.0 + 9.0 + 16.0) / 100.0;
    CHECK(relative_difference(result.interval.standard_uncertainty / result.interval.value, relative) < 0.03);
    CHECK(std::abs(influence_of(result, "critical damping").total.value - 0.5) < 0.03);
    CHECK(std::abs(influence_of(result, "density").total.value - 0.18) < 0.03);
    CHECK(std::abs(influence_of(result, "contact modulus").total.value - 0.32) < 0.03);
}

TEST_CASE("maugis-dugdale: draws are read from a map, that gives each as the solver does") {
    const RandomContact contact = random_contact(
        {.diameter = {"diameter", 8e-6},
         .density = {"density", 2158.5, 20.0},
         .work_of_adhesion = {"work of adhesion", 0.3, 0.02, lognormal_around},
         .contact_modulus = RandomInput{"contact modulus", 90e9, 5e9, lognormal_around},
         .parameters = {{cohesion_range, {"cohesion_range", 0.4e-9, 0.04e-9, lognormal_around}}}});
    const RandomInput damping{
        .name = fit_factor, .value = 2e-4, .standard_uncertainty = 1e-5, .distribution = lognormal_around};
    const Law law = Law::of<MaugisDugdale>();
    const PropagationOptions few{.samples = 16, .replicates = 4};
    const Propagation mapped = propagate_critical_velocity(law, Detachment::pull_off, damping, contact, few);
    std::vector<RandomInput> inputs{damping};
    inputs.insert(inputs.end(), contact.inputs.begin(), contact.inputs.end());
    const auto solved = [&](std::span<const double> values) {
        return critical_velocity({law,
                                  Detachment::pull_off,
                                  {DampingLaw::constant, values[0]},
                                  contact.contact(values.subspan(1))})
            .value;
    };
    const Propagation exact = propagate(inputs, solved, few);
    CHECK(relative_difference(mapped.interval.value, exact.interval.value) < CohesiveVelocityMap::accuracy());
    CHECK(relative_difference(mapped.median, exact.median) < CohesiveVelocityMap::accuracy());
    CHECK(relative_difference(*mapped.interval.lower, *exact.interval.lower) <
          CohesiveVelocityMap::accuracy());
    CHECK(relative_difference(*mapped.interval.upper, *exact.interval.upper) <
          CohesiveVelocityMap::accuracy());
    CHECK(mapped.influences.size() == 5);
    CHECK(influence_of(mapped, "cohesion_range").total.value > 1e-6);
    CHECK(relative_difference(influence_of(mapped, "work of adhesion").total.value,
                              influence_of(exact, "work of adhesion").total.value) < 1e-4);
}

TEST_CASE("a map of critical velocities: within its accuracy, beyond it solved, of every damping law") {
    ContactPair pair{
        .mass = 1e-12, .effective_radius = 4e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3};
    // At Tabor 1 the map would cross lambda = 0.94, where force over overlap gets a fold and v_c is not
    // smooth: all of it is solved.
    for (const double tabor : {2.0, 1.0})
        for (const auto& [damping_law, coefficient] :
             {std::pair{DampingLaw::constant, 2e-4}, std::pair{DampingLaw::tsuji, 0.2}}) {
            pair.parameters = {{stated_tabor.name, tabor}};
            CriticalVelocityProblem problem{
                Law::of<MaugisDugdale>(), Detachment::pull_off, {damping_law, coefficient}, pair};
            const CohesiveVelocityMap map(problem, {0.4, 0.3});
            for (const double share : {0.68, 0.8, 0.99, 1.2, 1.45, 3.0}) {  // the last one lies outside
                problem.damping.coefficient = coefficient * share;
                problem.contact.parameters = {{stated_tabor.name, tabor * std::pow(share, -0.7)}};
                CHECK(map.holds(cohesive_numbers(problem)) == (tabor > 1 && share < 1.5));
                const auto read = map(problem);
                REQUIRE(read.has_value());
                CHECK(relative_difference(*read, *critical_velocity(problem).value) <
                      CohesiveVelocityMap::accuracy());
            }
        }
}

TEST_CASE("with the damping read again, errors of the contact cancel in v_c; held, they do not") {
    const ContactModel model = ash_model(Law::of<BrachDunn>());
    SyntheticLaboratory laboratory = ash_laboratory(model, TrueDamping::quadratic);
    laboratory.camera.frames = 20;
    Random random(7);
    const DampingCurveFit fit = fit_damping_curve(model, laboratory.measure(random));
    const RandomContact contact =
        random_contact({.diameter = {"diameter", 96e-6},
                        .density = {"density", 2158.5},
                        .work_of_adhesion = {"work of adhesion", 0.2959},
                        .contact_modulus = RandomInput{"contact modulus", 90e9, 9e9}});
    const PropagationOptions few{.samples = 64, .replicates = 4};
    const Propagation reread =
        propagate_critical_velocity(fit, model, contact, DampingUnderChange::reread, few);
    const Propagation held = propagate_critical_velocity(fit, model, contact, DampingUnderChange::held, few);
    CHECK(reread.interval.standard_uncertainty < 0.3 * held.interval.standard_uncertainty);
    CHECK(influence_of(held, "contact modulus").total.value > 0.8);
    CHECK(influence_of(reread, fit_factor).total.value > 0.5);
    CHECK(relative_difference(reread.interval.value, fit.critical_velocity.value) < 1e-3);
    CHECK(reread.interval.standard_uncertainty > 0.8 * fit.critical_velocity.standard_uncertainty);
    CHECK(reread.influences.size() == 2);
}

TEST_CASE("thirty uncertain inputs, sixty dimensions of the sequence") {
    std::vector<RandomInput> inputs;
    inputs.reserve(30);
    for (int i = 0; i < 30; ++i)
        inputs.push_back(
            {.name = std::to_string(i), .value = 1.0, .standard_uncertainty = 0.1 * (i % 5 + 1)});
    const Propagation result = propagate(inputs, [](std::span<const double> x) {
        return std::optional(std::accumulate(x.begin(), x.end(), 0.0));
    });
    CHECK(result.interval.value == 30.0);
    CHECK(relative_difference(result.interval.standard_uncertainty, std::sqrt(6 * 0.55)) < 0.02);
    CHECK(std::abs(influence_of(result, "4").total.value - 0.25 / 3.3) < 0.02);
}
