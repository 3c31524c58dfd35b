// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts made with one damping law are explained by it, with its constants.
#include "solver/inference/damping_explanation.hpp"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/damping/brach_dunn.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

ContactPair sphere(double radius) {
    return {.mass = 4.0 / 3.0 * 3.141592653589793 * 2300 * radius * radius * radius,
            .effective_radius = radius,
            .contact_modulus = 90e9,
            .work_of_adhesion = 0.3};
}

/// Impacts of three spheres from @p slowest to forty times that, with the same constants.
std::vector<ImpactsOfSphere> laboratory(Law law, const Damping& damping, double adhesion_damping_value,
                                        double slowest, int points) {
    std::vector<ImpactsOfSphere> spheres;
    for (const double radius : {44e-6, 48e-6, 52e-6}) {
        ImpactsOfSphere each{.contact = sphere(radius), .impacts = {}};
        ContactPair contact = each.contact;
        if (!parameters_of(damping.law).empty())
            contact.parameters.set(adhesion_damping.name, adhesion_damping_value);
        for (int i = 0; i < points; ++i) {
            const double v = slowest * std::pow(40.0, i / (points - 1.0));
            const double e = restitution_of({law, law.default_detachment(), damping, contact, v});
            each.impacts.push_back({.velocity = v, .rebound = e * v});
        }
        spheres.push_back(std::move(each));
    }
    return spheres;
}

const DampingExplanation& of(const std::vector<DampingExplanation>& all, DampingLaw law) {
    return all.at(static_cast<std::size_t>(law));
}

}  // namespace

TEST_CASE("the damping law that made the impacts explains them with its constants, and v_c with them") {
    const Law law = Law::named("dmt");
    for (const Damping& truth :
         {Damping{DampingLaw::constant, 0.005}, Damping{DampingLaw::contact_radius, 1500.0},
          Damping{DampingLaw::tsuji, 0.4}, Damping{DampingLaw::hunt_crossley, 0.3}}) {
        CAPTURE(name_of(truth.law));
        const auto spheres = laboratory(law, truth, 0, 0.05, 24);
        const auto all = explain_by_damping(law, law.default_detachment(), spheres);
        REQUIRE(all.size() == all_values<DampingLaw>.size());
        const DampingExplanation& own = of(all, truth.law);
        CHECK(own.misfit < 1e-6);
        REQUIRE(own.constants.size() == 1);
        CHECK(relative_difference(own.constants[0].value, truth.coefficient) < 1e-5);
        for (const DampingExplanation& other : all)
            if (other.law != truth.law && other.law != DampingLaw::brach_dunn) CHECK(other.misfit > 0.005);
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const CriticalVelocity expected =
                critical_velocity({law, law.default_detachment(), truth, spheres[i].contact});
            REQUIRE(own.velocities[i]);
            CHECK(relative_difference(*own.velocities[i]->value, *expected.value) < 1e-4);
        }
    }
}

TEST_CASE("two constants are found where adhesion counts, and refused where it does not") {
    const Law law = Law::named("dmt");
    const Damping truth{DampingLaw::brach_dunn, 0.2};
    const auto near =
        explain_by_damping(law, law.default_detachment(), laboratory(law, truth, 2.0, 0.03, 24));
    const DampingExplanation& own = of(near, DampingLaw::brach_dunn);
    CHECK(own.misfit < 1e-5);
    REQUIRE(own.constants.size() == 2);
    CHECK(relative_difference(own.constants[0].value, 0.2) < 1e-2);
    CHECK(relative_difference(own.constants[1].value, 2.0) < 1e-2);
    CHECK(std::abs(*own.correlation) < greatest_correlation);
    // Without adhesion nothing depends on the second constant.
    const Law hertz = Law::named("hertz");
    const auto far =
        explain_by_damping(hertz, hertz.default_detachment(), laboratory(hertz, truth, 2.0, 0.03, 12));
    const DampingExplanation& untold = of(far, DampingLaw::brach_dunn);
    CHECK(untold.constants.empty());
    CHECK(untold.correlation);
    CHECK(untold.misfit < 1e-5);
    CHECK(of(far, DampingLaw::hunt_crossley).misfit < 1e-6);
}

TEST_CASE(
    "constants stay where they are when many impacts are averaged, and uncertainties fall with scatter") {
    const Law law = Law::named("jkr");
    const Damping truth{DampingLaw::contact_radius, 1500.0};
    auto spheres = laboratory(law, truth, 0, 0.1, 400);
    double sign = 0.02;
    for (ImpactsOfSphere& each : spheres)
        for (Measurement& impact : each.impacts) {
            if (impact.rebound > 0) impact.rebound *= 1 + sign;
            sign = -sign;
        }
    const auto all = explain_by_damping(law, law.default_detachment(), spheres);
    const DampingConstant& found = of(all, DampingLaw::contact_radius).constants.front();
    CHECK(relative_difference(found.value, truth.coefficient) < 0.02);
    CHECK(found.uncertainty > 0);
    CHECK(std::abs(found.value - truth.coefficient) < 4 * found.uncertainty + 1e-3 * truth.coefficient);
}

TEST_CASE("two impacts explain nothing") {
    const Law law = Law::named("dmt");
    std::vector<ImpactsOfSphere> spheres{{.contact = sphere(44e-6), .impacts = {}}};
    spheres.front().impacts = {{.velocity = 1, .rebound = 0.5}, {.velocity = 2, .rebound = 1.2}};
    CHECK_THROWS_AS(static_cast<void>(explain_by_damping(law, law.default_detachment(), spheres)),
                    InputError);
}
