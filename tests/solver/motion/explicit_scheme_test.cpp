// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's own scheme, Eqs. 31-34: its order, its limit, its captures, and what it cannot treat.
#include "solver/motion/explicit_scheme.hpp"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

ImpactResult with_steps(const Impact& impact, double steps) {
    return solve_impact_explicit(impact, {.time_step = explicit_time_step(impact, steps)});
}

/// The laws whose force is a function of overlap.
std::vector<Impact> treatable(double damping_number, double velocity) {
    std::vector<Impact> impacts;
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        impacts.push_back(impact_of({law, DampingLaw::constant, Detachment::zero_overlap}, ash(0.3),
                                    damping_number, velocity));
    }
    return impacts;
}

/// Value in the limit of no time step, from three runs of a first-order scheme.
double extrapolated(double coarse, double middle, double fine) {
    const double first = 2.0 * middle - coarse;
    const double second = 2.0 * fine - middle;
    return second + (second - first) / (std::sqrt(8.0) - 1.0);  // the next error is of order 3/2
}

}  // namespace

TEST_CASE("the scheme is of first order: half the step, half the error") {
    for (const Impact& impact : treatable(0.3, 2.0)) {
        const ImpactResult exact = solve_impact(impact);
        CAPTURE(describe(impact));
        double error_before = 0.0;
        double time_before = 0.0;
        for (const double steps : {1e3, 2e3, 4e3, 8e3, 16e3, 32e3}) {
            const ImpactResult result = with_steps(impact, steps);
            const double error = std::abs(result.restitution - exact.restitution);
            const double time = std::abs(*result.contact_time - *exact.contact_time);
            CAPTURE(steps);
            if (error_before > 0.0) {
                const double order = std::log2(error_before / error);
                const double time_order = std::log2(time_before / time);
                CHECK(std::abs(order - 1.0) < 0.03);
                CHECK(std::abs(time_order - 1.0) < 0.03);
            }
            error_before = error;
            time_before = time;
        }
        CHECK(error_before < 1e-4);
    }
}

TEST_CASE("the scheme converges to the exact solution") {
    Worst worst;
    for (const double number : {0.05, 0.3, 0.7}) {
        for (const Impact& impact : treatable(number, 2.0)) {
            const ImpactResult a = with_steps(impact, 10e3);
            const ImpactResult b = with_steps(impact, 20e3);
            const ImpactResult c = with_steps(impact, 40e3);
            const ImpactResult exact = solve_impact(impact);
            const auto limit = [&](auto&& of) { return extrapolated(of(a), of(b), of(c)); };
            const auto see = [&](double scheme, double expected) {
                worst.see(relative_difference(scheme, expected), describe(impact));
            };
            see(limit([](const ImpactResult& r) { return r.restitution; }), exact.restitution);
            see(limit([](const ImpactResult& r) { return *r.contact_time; }), *exact.contact_time);
            see(limit([](const ImpactResult& r) { return r.maximum_overlap; }), exact.maximum_overlap);
            see(limit([](const ImpactResult& r) { return r.energy.dissipated; }), exact.energy.dissipated);
        }
    }
    CHECK_MESSAGE(worst.deviation() < 1e-6, worst.where());
}

TEST_CASE("its ledger closes no better than the scheme: the residual is the energy error, first order too") {
    for (const Impact& impact : treatable(0.3, 2.0)) {
        const EnergyLedger coarse = with_steps(impact, 2000.0).energy;
        const EnergyLedger fine = with_steps(impact, 4000.0).energy;
        CAPTURE(describe(impact));
        for (const EnergyLedger& energy : {coarse, fine}) {
            CHECK(std::abs(energy.incident + energy.at_touch - energy.remaining - energy.potential -
                           energy.dissipated - energy.residual) < 1e-15 * energy.incident);
        }
        CHECK(std::abs(coarse.residual / fine.residual - 2.0) < 0.1);
        CHECK(std::abs(fine.residual) < 1e-3 * fine.incident);
    }
}

TEST_CASE("a capture is told from a rebound, ringing or creeping") {
    for (const double number : {1.2, 3.0, 30.0}) {
        for (const Impact& impact : treatable(number, 2.0)) {
            const ImpactResult exact = solve_impact(impact);
            const ImpactResult result = with_steps(impact, 4000.0 * (1.0 + number));
            CAPTURE(describe(impact));
            REQUIRE(exact.outcome == Outcome::capture);
            CHECK(result.outcome == Outcome::capture);
            CHECK(result.restitution == 0.0);
            CHECK(!result.contact_time);
            CHECK(result.approach_time.has_value() == exact.approach_time.has_value());
            CHECK(relative_difference(result.maximum_overlap, exact.maximum_overlap) < 5e-3);
        }
    }
}

TEST_CASE("no capture needs more than its ringing to be told, and its ledger ends at greatest overlap") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        for (const double number : {1e-2, 1.0, 1.3, 10.0, 1e3}) {
            for (const double velocity : {1e-4, 2.0}) {
                const Impact impact = impact_of({law, DampingLaw::constant, Detachment::zero_overlap},
                                                ash(0.3), number, velocity);
                const ImpactResult exact = solve_impact(impact);
                if (exact.outcome != Outcome::capture) continue;
                CAPTURE(describe(impact));
                const ImpactResult result = solve_impact_explicit(
                    impact, {.time_step = explicit_time_step(impact, 20e3) / 4, .most_steps = 800'000});
                CHECK(result.outcome == Outcome::capture);
                CHECK(result.approach_time.has_value() == exact.approach_time.has_value());
                const double size = std::max(exact.energy.incident, -exact.energy.minimum);
                CHECK(std::abs(result.energy.dissipated - exact.energy.dissipated) < 1e-2 * size);
                CHECK(std::abs(result.energy.potential - exact.energy.potential) < 1e-2 * size);
                CHECK(result.energy.remaining == 0.0);
            }
        }
    }
}

TEST_CASE("a time step that the damping or the contact itself makes too long is refused") {
    Impact impact = treatable(0.3, 2.0)[0];
    const auto message = [&](double time_step) {
        return input_error_of([&] { return solve_impact_explicit(impact, {time_step}); });
    };
    CHECK(contains(message(1e-7), "time_step is 1e-07 s, too long for this impact; allowed: up to 1.879"));
    impact.damping.coefficient = 10.0;
    const double damping_time = impact.contact.mass / 10.0;
    CHECK(contains(message(1.01 * damping_time), "too long for this impact; allowed: up to 9.277"));
    CHECK(message(0.99 * damping_time).empty());
    CHECK(relative_difference(explicit_time_step(impact, 100.0), damping_time / 100.0) < 1e-12);
}

TEST_CASE("an approach that never turns ends at equilibrium, as in the exact solution") {
    Impact impact = treatable(0.3, 0.01)[1];
    impact.damping.coefficient = 0.0153;
    const ImpactResult exact = solve_impact(impact);
    const ImpactResult result = with_steps(impact, 2000.0);
    REQUIRE(!exact.approach_time);
    CHECK(result.outcome == Outcome::capture);
    CHECK(!result.approach_time);
    CHECK(relative_difference(result.maximum_overlap, exact.maximum_overlap) < 1e-12);
}

TEST_CASE("what the scheme cannot treat is refused with what it can") {
    Impact impact = treatable(0.3, 2.0)[1];
    const auto message = [&](double time_step) {
        return input_error_of([&] { return solve_impact_explicit(impact, {time_step}); });
    };
    CHECK(message(0.0) == "time_step is 0 s; allowed: a finite number > 0 s");
    CHECK(contains(message(-1e-10), "time_step is"));
    CHECK(contains(message(std::nan("")), "time_step is"));

    impact.law = Law::of<Jkr>();
    CHECK(message(1e-10) ==
          "the paper's explicit scheme cannot treat law 'jkr': its force is not a function of overlap; "
          "allowed: hertz, dmt, brach-dunn, sjkr");
    impact.law = Law::of<Hertz>();
    impact.detachment = Detachment::zero_force;
    CHECK(message(1e-10) ==
          "the paper's explicit scheme ends contact at zero overlap; allowed: zero-overlap");
    impact.detachment = Detachment::zero_overlap;
    impact.damping.law = DampingLaw::tsuji;
    CHECK(message(1e-10) == "the paper's explicit scheme has constant damping; allowed: constant");
    impact.damping = {DampingLaw::constant, -1.0};
    CHECK(contains(message(1e-10), "damping is -1 kg/s"));
}

TEST_CASE("the step limit ends a run that was asked for too small a step") {
    const Impact impact = treatable(0.3, 2.0)[0];
    CHECK_THROWS_AS(static_cast<void>(solve_impact_explicit(
                        impact, {.time_step = explicit_time_step(impact, 1e6), .most_steps = 1000})),
                    ConvergenceError);
}

TEST_CASE("the suggested time step gives about that many steps in an undamped Hertz contact") {
    const Impact impact = treatable(0.0, 2.0)[0];
    const double step = explicit_time_step(impact, 500.0);
    CHECK(relative_difference(step * 500.0, *solve_impact(impact).contact_time) < 1e-8);
    CHECK(std::abs(with_steps(impact, 500.0).steps - 500) <= 2);
}
