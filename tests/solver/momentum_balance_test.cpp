#include "solver/momentum_balance.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "solver/trajectory.hpp"
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

TEST_CASE("each stage's impulses add up to its momentum, Eqs. 36 to 39, and the better the more points") {
    Worst half_powers;
    Worst quarter_powers;
    Worst improvement;
    for (const ContactCase& c : contact_cases()) {
        for (const double number : damping_numbers) {
            const Impact impact = impact_of(c, ash(0.3), number, 2.0);
            const ImpactResult result = solve_impact(impact);
            if (result.outcome == Outcome::capture) continue;
            const MomentumBalance coarse = momentum_balance(impact, 501);
            const MomentumBalance fine = momentum_balance(impact, 4001);
            const double momentum = impact.contact.mass * impact.velocity;
            CAPTURE(describe(impact));
            for (const StageMomentum* stage : {&fine.approach, &fine.rebound}) {
                // Tsuji's damping has quarter powers of time at the ends, the others half-integer ones.
                Worst& residual = impact.damping.law == DampingLaw::tsuji ? quarter_powers : half_powers;
                residual.see(std::abs(stage->residual) / momentum, describe(impact));
                CHECK(relative_difference(stage->mean_force * stage->duration, stage->static_impulse) <
                      1e-14);
                CHECK(stage->damping_impulse > 0.0);
            }
            const double before = std::abs(coarse.approach.residual) + std::abs(coarse.rebound.residual);
            const double after = std::abs(fine.approach.residual) + std::abs(fine.rebound.residual);
            // Where a contact yields the force has a kink, whose place between two points is a matter of
            // luck.
            if (before > 1e-6 * momentum && !result.yielded)
                improvement.see(after / before, describe(impact));
            CHECK(relative_difference(fine.approach.duration, *result.approach_time) < 1e-14);
            CHECK(relative_difference(fine.rebound.duration, *result.contact_time - *result.approach_time) <
                  1e-13);
            CHECK(relative_difference(fine.momentum_lost,
                                      impact.contact.mass * (impact.velocity - result.rebound_velocity)) <
                  1e-13);
        }
    }
    CHECK_MESSAGE(half_powers.deviation() < 1e-5, half_powers.where());
    CHECK_MESSAGE(quarter_powers.deviation() < 1e-4, quarter_powers.where());
    CHECK_MESSAGE(improvement.deviation() < std::pow(8.0, -1.2), improvement.where());
}

TEST_CASE("constant damping: its impulse is eta delta_max in each stage, Eqs. 38 and 39") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        const Impact impact = impact_with(law, 0.3, 0.3, 2.0);
        const MomentumBalance balance = momentum_balance(impact, 4001);
        const double expected = impact.damping.coefficient * solve_impact(impact).maximum_overlap;
        CAPTURE(law.name());
        CHECK(relative_difference(balance.approach.damping_impulse, expected) < 1e-6);
        CHECK(relative_difference(balance.rebound.damping_impulse, expected) < 1e-6);
        CHECK(relative_difference(balance.damping_impulse, 2.0 * expected) < 1e-6);
    }
}

TEST_CASE("without adhesion (44) and (45) hold; adhesion that rivals the impact breaks (44), not (45)") {
    for (const double number : {0.05, 0.3, 0.8}) {
        const MomentumBalance balance = momentum_balance(impact_with(Law::of<Hertz>(), 0.0, number, 2.0));
        CAPTURE(number);
        CHECK(balance.damping_exceeds_loss());
        CHECK(balance.rebound_is_longer());
    }
    const MomentumBalance adhesive = momentum_balance(impact_with(Law::of<Jkr>(), 1.0, 0.005, 0.04));
    CHECK(!adhesive.damping_exceeds_loss());
    CHECK(adhesive.rebound_is_longer());
}

TEST_CASE("a capture has no balance of a rebound") {
    CHECK(input_error_of(
              [] { static_cast<void>(momentum_balance(impact_with(Law::of<Dmt>(), 0.3, 2.0, 0.5))); }) ==
          "a captured particle has no momentum balance of a rebound; allowed: a velocity above the critical "
          "one");
}
