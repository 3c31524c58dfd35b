// SPDX-License-Identifier: GPL-3.0-or-later
// Maugis-Dugdale impacts against an integration in time that shares neither coordinates nor series.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/transition.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scale.hpp"
#include "tests/oracles/maugis_impact.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::oracles {

using test::Random;
using test::relative_difference;

namespace {

/// The impact in SI units, of 10 um ash.
Impact in_si(const MaugisCase& c) {
    ContactPair pair{
        .mass = 1.2e-12, .effective_radius = 5e-6, .contact_modulus = 60e9, .work_of_adhesion = 0.25};
    pair.parameters = {{stated_tabor.name, c.lambda / transition_per_tabor()}};
    const double unit = maugis_velocity(pair);
    const Scale scale = Scale::of(pair, unit);
    return {.law = ashimpact::Law::of<MaugisDugdale>(),
            .detachment = c.detachment,
            .damping = {c.damping_law, scale.damping_coefficient(c.damping_law, c.damping)},
            .contact = pair,
            .velocity = c.velocity * unit};
}

MaugisCase random_case(Random& random) {
    constexpr ashimpact::Detachment ends[] = {ashimpact::Detachment::pull_off,
                                              ashimpact::Detachment::zero_overlap,
                                              ashimpact::Detachment::load_controlled};
    MaugisCase c{.lambda = random.log_uniform(0.05, 50.0),
                 .damping_law = all_values<DampingLaw>[random.below(all_values<DampingLaw>.size())],
                 .damping = random.uniform(0.0, 0.5),
                 .velocity = random.log_uniform(0.5, 50.0),
                 .detachment = ends[random.below(3)]};
    if (cohesive_refusal(CohesiveZone(c.lambda), c.detachment))
        c.detachment = ashimpact::Detachment::pull_off;
    return c;
}

}  // namespace

TEST_CASE("200 random Maugis-Dugdale impacts agree with their integration in time to 1e-8") {
    Random random(1992);
    int rebounds = 0;
    int captures = 0;
    for (int i = 0; i < test::repetitions(200); ++i) {
        const MaugisCase c = random_case(random);
        CAPTURE(c.lambda);
        CAPTURE(c.damping);
        CAPTURE(c.velocity);
        CAPTURE(ashimpact::name_of(c.damping_law));
        CAPTURE(ashimpact::name_of(c.detachment));
        const Impact impact = in_si(c);
        const MaugisUnits units = maugis_units(impact.contact);
        const double time = units.overlap / maugis_velocity(impact.contact);
        const ashimpact::ImpactResult solved = solve_impact(impact);
        const MaugisResult integrated = maugis_impact(c);
        REQUIRE((solved.outcome == Outcome::rebound) == integrated.rebound);
        CHECK(relative_difference(solved.maximum_overlap, integrated.maximum_overlap * units.overlap) < 1e-8);
        (integrated.rebound ? rebounds : captures) += 1;
        if (!integrated.rebound) continue;
        CHECK(std::abs(solved.restitution - integrated.restitution) < 1e-8);
        CHECK(relative_difference(*solved.contact_time, *integrated.contact_time * time) < 1e-8);
    }
    CHECK(rebounds >= test::repetitions(200) / 4);
    CHECK(captures >= test::repetitions(200) / 5);
}

TEST_CASE("the work lost in both jumps is the integral of the force from the fold to the reach") {
    for (const double lambda : {0.05, 0.3, 0.65, 0.7, 0.93, 0.95, 2.0, 10.0, 50.0}) {
        CAPTURE(lambda);
        const auto energy = static_cast<double>(CohesiveZone(lambda).separation_energy());
        CHECK(relative_difference(energy, maugis_separation_energy(lambda)) < 1e-12);
    }
}

}  // namespace ashimpact::oracles
