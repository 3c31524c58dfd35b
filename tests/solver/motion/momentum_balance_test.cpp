// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "solver/motion/trajectory.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

Impact impact_with(Law law, double w, double number, double velocity) {
    return impact_of({law, DampingLaw::constant, law.default_detachment()}, ash(w), number, velocity);
}

}  // namespace

TEST_CASE("each stage's impulses add up to its momentum, Eqs. 36 to 39, to rounding") {
    Worst residual;
    Worst split;
    for (const ContactCase& c : contact_cases()) {
        for (const double number : damping_numbers) {
            const Impact impact = impact_of(c, ash(0.3), number, 2.0);
            const ImpactResult result = solve_impact(impact);
            if (result.outcome == Outcome::capture) continue;
            const MomentumBalance balance = momentum_balance(impact);
            const double momentum = impact.contact.mass * impact.velocity;
            CAPTURE(describe(impact));
            CHECK(relative_difference(balance.incident_momentum, momentum) < 1e-15);
            for (const StageMomentum* stage : {&balance.approach, &balance.rebound}) {
                residual.see(std::abs(stage->residual) / momentum, describe(impact));
                CHECK(relative_difference(stage->mean_force * stage->duration, stage->static_impulse) <
                      1e-14);
                CHECK(stage->damping_impulse > 0.0);
            }
            const double damping = balance.approach.damping_impulse + balance.rebound.damping_impulse;
            split.see(relative_difference(balance.damping_impulse, damping), describe(impact));
            split.see(relative_difference(balance.approach.duration, *result.approach_time),
                      describe(impact));
            split.see(
                relative_difference(balance.rebound.duration, *result.contact_time - *result.approach_time),
                describe(impact));
            split.see(std::abs(balance.momentum_lost - momentum * (1.0 - result.restitution)) / momentum,
                      describe(impact));
        }
    }
    CHECK(residual.count() > 50);
    CHECK_MESSAGE(residual.deviation() < 1e-15, residual.where());
    CHECK_MESSAGE(split.deviation() < 1e-13, split.where());
}

TEST_CASE("the impulses are those of the sampled trajectory, by the trapezoidal rule") {
    for (const ContactCase& c : contact_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const ImpactResult result = solve_impact(impact);
        if (result.outcome == Outcome::capture) continue;
        CAPTURE(describe(impact));
        const MomentumBalance balance = momentum_balance(impact);
        const auto path = trajectory(impact, 4001);
        double contact = 0.0;
        double damping = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const double step = (path[i].time - path[i - 1].time) / 2.0;
            for (const TrajectoryPoint& p : {path[i - 1], path[i]}) {
                contact += step * (p.repulsive_force + p.attractive_force);
                damping += step * std::abs(p.damping_force);
            }
        }
        // Forces have half-integer powers of time at both ends, with Tsuji's damping quarter ones.
        const double both = balance.approach.static_impulse + balance.rebound.static_impulse;
        CHECK(std::abs(contact - both) < 2e-4 * balance.incident_momentum);
        CHECK(std::abs(damping - balance.damping_impulse) < 2e-4 * balance.incident_momentum);
    }
}

TEST_CASE("constant damping: its impulse is eta delta_max in each stage, Eqs. 38 and 39") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        const Impact impact = impact_with(law, 0.3, 0.3, 2.0);
        const MomentumBalance balance = momentum_balance(impact);
        const double expected = impact.damping.coefficient * solve_impact(impact).maximum_overlap;
        CAPTURE(law.name());
        CHECK(relative_difference(balance.approach.damping_impulse, expected) < 1e-14);
        CHECK(relative_difference(balance.rebound.damping_impulse, expected) < 1e-14);
        CHECK(relative_difference(balance.damping_impulse, 2.0 * expected) < 1e-14);
    }
}

TEST_CASE("without adhesion (44) and (45) hold; adhesion that rivals the impact breaks (44), not (45)") {
    for (const double number : {1e-9, 0.05, 0.3, 0.8}) {
        const MomentumBalance balance = momentum_balance(impact_with(Law::of<Hertz>(), 0.0, number, 2.0));
        CAPTURE(number);
        CHECK(balance.damping_exceeds_loss());
        CHECK(balance.rebound_is_longer());
        CHECK(contains(verdict_of(balance), "(44) holds: damping impulse "));
        CHECK(contains(verdict_of(balance), "(45) holds: rebound "));
    }
    const MomentumBalance adhesive = momentum_balance(impact_with(Law::of<Jkr>(), 1.0, 0.005, 0.04));
    CHECK(!adhesive.damping_exceeds_loss());
    CHECK(adhesive.rebound_is_longer());
    CHECK(contains(verdict_of(adhesive), "(44) does not hold: damping impulse "));
}

TEST_CASE("without damping both sides of (44) and (45) are equal, so neither inequality holds") {
    const MomentumBalance balance = momentum_balance(impact_with(Law::of<Hertz>(), 0.0, 0.0, 2.0));
    CHECK(!balance.damping_exceeds_loss());
    CHECK(!balance.rebound_is_longer());
    CHECK(std::abs(balance.mean_force_ratio() - 1.0) < 1e-14);
    CHECK(
        contains(verdict_of(balance), "(45) does not hold: rebound 9.39645e-08 s = 9.39645e-08 s approach"));
    CHECK(contains(verdict_of(balance), "are as 1 to 1"));
}

TEST_CASE("a capture has no balance of a rebound") {
    CHECK(input_error_of(
              [] { static_cast<void>(momentum_balance(impact_with(Law::of<Dmt>(), 0.3, 2.0, 0.5))); }) ==
          "a captured particle has no momentum balance of a rebound; allowed: a velocity above the critical "
          "one");
}
