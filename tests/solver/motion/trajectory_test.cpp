// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's own scheme, Eqs. 31-34: its order, its limit, its captures, and what it cannot treat.
#include "solver/motion/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/explicit_scheme.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/quadrature.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr int points = 2049;

/// Impacts that rebound, of every kind.
template <class Action>
void for_each_rebound(Action&& action) {
    for (const ContactCase& c : elastic_cases()) {
        for (const double v : {0.5, 2.0}) {
            for (const double number : damping_numbers) {
                const Impact impact = impact_of(c, ash(0.3), number, v);
                const ImpactResult result = solve_impact(impact);
                if (result.outcome == Outcome::rebound) action(impact, result);
            }
        }
    }
}

double force_on(const TrajectoryPoint& p) {
    return p.repulsive_force + p.attractive_force + p.damping_force;
}

std::vector<double> forces_of(const std::vector<TrajectoryPoint>& path) {
    std::vector<double> forces;
    forces.reserve(path.size());
    for (const TrajectoryPoint& p : path) forces.push_back(force_on(p));
    return forces;
}

/// Where the velocity changes sign, and the overlap there: cubic Hermite interpolation between two samples,
/// with the acceleration from the forces.
struct Turn {
    double time;
    double overlap;
};

Turn turn_of(const Impact& impact, const std::vector<TrajectoryPoint>& path) {
    std::size_t i = 0;
    while (path[i + 1].velocity > 0.0) ++i;
    const TrajectoryPoint& a = path[i];
    const TrajectoryPoint& b = path[i + 1];
    const double h = b.time - a.time;
    const auto hermite = [h](double y0, double d0, double y1, double d1, double t) {
        return (1 + 2 * t) * (1 - t) * (1 - t) * y0 + t * (1 - t) * (1 - t) * h * d0 +
               t * t * (3 - 2 * t) * y1 + t * t * (t - 1) * h * d1;
    };
    const auto velocity = [&](double t) {
        return hermite(a.velocity, -force_on(a) / impact.contact.mass, b.velocity,
                       -force_on(b) / impact.contact.mass, t);
    };
    double lower = 0.0;
    double upper = 1.0;
    for (int n = 0; n < 60; ++n) {
        const double middle = (lower + upper) / 2;
        (velocity(middle) > 0.0 ? lower : upper) = middle;
    }
    return {a.time + lower * h, hermite(a.overlap, a.velocity, b.overlap, b.velocity, lower)};
}

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

TEST_CASE("a trajectory runs from first touch to the end of contact, evenly in time") {
    Worst worst;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        const auto path = trajectory(impact, 33);
        CAPTURE(describe(impact));
        REQUIRE(path.size() == 33);
        CHECK(path.front().time == 0.0);
        CHECK(path.front().velocity == impact.velocity);
        double first = 0.0;
        if (is_cohesive(impact.law, impact.contact) && impact.detachment != Detachment::zero_overlap) {
            const CohesiveZone zone(transition_parameter(impact.contact));  // begins within reach
            first = static_cast<double>(-zone.reach()) * maugis_units(impact.contact).overlap;
        }
        CHECK(std::abs(path.front().overlap - first) < 1e-15 * result.maximum_overlap);
        for (std::size_t i = 0; i < path.size(); ++i) {
            worst.see(std::abs(path[i].time / *result.contact_time - static_cast<double>(i) / 32.0),
                      describe(impact));
        }
        worst.see(std::abs(path.back().velocity + result.rebound_velocity) / impact.velocity,
                  describe(impact));
    });
    CHECK(worst.count() > 1000);
    CHECK_MESSAGE(worst.deviation() < 1e-14, worst.where());
}

TEST_CASE("the turning point of a trajectory is that of the impact") {
    Worst time;
    Worst overlap;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        const Turn turn = turn_of(impact, trajectory(impact, points));
        time.see(relative_difference(turn.time, result.approach_time.value()), describe(impact));
        overlap.see(relative_difference(turn.overlap, result.maximum_overlap), describe(impact));
    });
    CHECK(time.count() >= 120);
    CHECK_MESSAGE(time.deviation() < 1e-10, time.where());
    CHECK_MESSAGE(overlap.deviation() < 1e-12, overlap.where());
}

TEST_CASE("overlap, velocity and forces of a trajectory are each other's derivatives: Eq. 2") {
    Worst velocity;
    Worst acceleration;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        const auto path = trajectory(impact, points);
        const double h = *result.contact_time / (points - 1);
        const double greatest =
            std::abs(force_on(*std::max_element(path.begin(), path.end(), [](const auto& a, const auto& b) {
                return force_on(a) < force_on(b);
            })));
        // Away from the ends, where half-integer powers of time spoil a difference.
        for (std::size_t i = 256; i + 256 < path.size(); i += 64) {
            const auto derivative = [&](auto&& of) {
                return (8 * (of(path[i + 1]) - of(path[i - 1])) - (of(path[i + 2]) - of(path[i - 2]))) /
                       (12 * h);
            };
            const double v = derivative([](const TrajectoryPoint& p) { return p.overlap; });
            const double a = derivative([](const TrajectoryPoint& p) { return p.velocity; });
            velocity.see(std::abs(v - path[i].velocity) / impact.velocity, describe(impact));
            acceleration.see(std::abs(impact.contact.mass * a + force_on(path[i])) / greatest,
                             describe(impact));
        }
    });
    CHECK_MESSAGE(velocity.deviation() < 1e-10, velocity.where());
    CHECK_MESSAGE(acceleration.deviation() < 1e-10, acceleration.where());
}

TEST_CASE(
    "momentum: the impulse of all forces is m (v_in - v) at every eighth of the contact, Eqs. 36 and 37") {
    Worst whole;
    Worst part;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        if (impact.damping.law == DampingLaw::tsuji) return;  // quarter powers of time at the ends
        if (impact.law == Law::of<MaugisDugdale>())
            return;  // steep at the fold; maugis_impact_test balances it
        const auto path = trajectory(impact, points);
        const std::vector<double> forces = forces_of(path);
        const double h = *result.contact_time / (points - 1);
        const double m = impact.contact.mass;
        const double v = impact.velocity;
        whole.see(relative_difference(romberg(forces, h), m * (v + result.rebound_velocity)),
                  describe(impact));
        // Halves and quarters from either end are 2^n intervals long.
        for (const std::size_t n : {points / 8, points / 4, points / 2}) {
            const auto first = std::span(forces).first(n + 1);
            const auto last = std::span(forces).last(n + 1);
            const double v_last = path[path.size() - 1 - n].velocity;
            part.see(std::abs(romberg(first, h) - m * (v - path[n].velocity)) / (m * v), describe(impact));
            part.see(std::abs(romberg(last, h) - m * (v_last + result.rebound_velocity)) / (m * v),
                     describe(impact));
        }
    });
    CHECK(whole.count() >= 80);
    CHECK_MESSAGE(whole.deviation() < 1e-8, whole.where());
    CHECK_MESSAGE(part.deviation() < 1e-8, part.where());
}

TEST_CASE("constant damping: its impulse is eta delta, and the rest is that of F_tot, Eqs. 35, 38 and 39") {
    Worst worst;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        if (impact.damping.law != DampingLaw::constant) return;
        const auto path = trajectory(impact, points);
        std::vector<double> damping;
        std::vector<double> contact;
        for (const TrajectoryPoint& p : path) {
            damping.push_back(p.damping_force);
            contact.push_back(p.repulsive_force + p.attractive_force);
            CHECK(relative_difference(p.damping_force, impact.damping.coefficient * p.velocity) < 1e-13);
        }
        const double h = *result.contact_time / (points - 1);
        const double eta = impact.damping.coefficient;
        const double momentum = impact.contact.mass * impact.velocity;
        for (const std::size_t n : {points / 8, points / 4, points / 2}) {
            const double way = path[n].overlap - path[0].overlap;
            const double impulse = romberg(std::span(damping).first(n + 1), h);
            worst.see(std::abs(impulse - eta * way) / momentum, describe(impact));
            const double rest = romberg(std::span(contact).first(n + 1), h);
            const double expected = impact.contact.mass * (impact.velocity - path[n].velocity) - eta * way;
            worst.see(std::abs(rest - expected) / momentum, describe(impact));
        }
    });
    CHECK(worst.count() > 200);
    CHECK_MESSAGE(worst.deviation() < 1e-9, worst.where());
}

TEST_CASE("a trajectory's repulsion is K a^3/R*, as damping takes it, and the rest attraction") {
    Worst worst;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        const StaticCurve curve(impact.law, impact.contact);
        for (const TrajectoryPoint& p : trajectory(impact, 9)) {
            if (p.contact_radius <= curve.first().contact_radius) continue;
            const StaticPoint expected = curve.at_contact_radius(p.contact_radius);
            const double hertz = 4.0 / 3.0 * impact.contact.contact_modulus * std::pow(p.contact_radius, 3) /
                                 impact.contact.effective_radius;
            const double size = hertz + std::abs(expected.force());
            worst.see(std::abs(p.overlap - expected.overlap) / result.maximum_overlap, describe(impact));
            worst.see(std::abs(p.repulsive_force - hertz) / size, describe(impact));
            worst.see(std::abs(p.repulsive_force + p.attractive_force - expected.force()) / size,
                      describe(impact));
        }
    });
    CHECK(worst.count() > 3000);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("a captured particle rings down: its energy only falls, until it rests at equilibrium") {
    int settled = 0;
    for (const ContactCase& c : contact_cases()) {
        const Impact impact = impact_of(c, ash(1.0), 0.9, 0.05);
        const ImpactResult result = solve_impact(impact);
        if (result.outcome != Outcome::capture) continue;
        const auto path = trajectory(impact, 400);
        CAPTURE(describe(impact));
        REQUIRE(path.size() == 400);
        double greatest = 0.0;
        for (const TrajectoryPoint& p : path) greatest = std::max(greatest, p.overlap);
        CHECK(greatest < result.maximum_overlap * (1.0 + 1e-12));
        // One that never turns ends below the supremum.
        if (result.approach_time) CHECK(greatest > 0.99 * result.maximum_overlap);
        CHECK(path.back().time > result.approach_time.value_or(0.0));
        CHECK(std::abs(path.back().velocity) < 0.0101 * impact.velocity);
        const double stiff = path.back().repulsive_force;
        CHECK(std::abs(force_on(path.back())) < 0.2 * stiff);
        ++settled;
    }
    CHECK(settled > 3);
}

TEST_CASE("a trajectory that creeps up to equilibrium never passes it") {
    const Impact impact{
        Law::of<Dmt>(), Detachment::zero_overlap, {DampingLaw::constant, 0.0153}, ash(0.3), 0.01};
    const double equilibrium = solve_impact(impact).maximum_overlap;
    double before = -1.0;
    for (const TrajectoryPoint& p : trajectory(impact, 50)) {
        CHECK(p.overlap > before);
        CHECK(p.overlap <= equilibrium);
        CHECK(p.velocity > 0.0);
        before = p.overlap;
    }
    CHECK(before > 0.9 * equilibrium);
}

TEST_CASE("a trajectory takes two points or more of an admissible impact") {
    const Impact impact = impact_of(contact_cases().front(), ash(0.0), 0.3, 2.0);
    CHECK(trajectory(impact, 2).size() == 2);
    CHECK(input_error_of([&] { return trajectory(impact, 1); }) ==
          "trajectory has 1 points; allowed: at least 2");
    Impact wrong = impact;
    wrong.velocity = 0.0;
    CHECK(contains(input_error_of([&] { return trajectory(wrong, 10); }), "velocity is 0 m/s"));
}

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

TEST_CASE("the scheme's own critical velocity and damping, which tend to the exact ones with the step") {
    for (const Impact& impact : treatable(0.3, 2.0)) {
        CAPTURE(describe(impact));
        const double exact =
            *critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value;
        Impact critical = impact;
        critical.velocity = exact;
        std::vector<double> difference;
        for (const double steps : {2e3, 4e3}) {
            const ExplicitSchemeOptions options{.time_step = explicit_time_step(critical, steps)};
            const double found = explicit_critical_velocity(critical, options);
            difference.push_back(found / exact - 1);
            critical.velocity = found * (1 + 1e-9);
            CHECK(solve_impact_explicit(critical, options).outcome == Outcome::rebound);
            critical.velocity = found * (1 - 1e-9);
            CHECK(solve_impact_explicit(critical, options).outcome == Outcome::capture);
            critical.velocity = exact;
        }
        CHECK(std::abs(difference[0]) < 0.02);
        CHECK(difference[0] / difference[1] == doctest::Approx(2.0).epsilon(0.1));

        const ExplicitSchemeOptions options{.time_step = explicit_time_step(impact, 2e3)};
        Impact damped = impact;
        damped.damping.coefficient = explicit_damping(impact, 0.3, options);
        CHECK(std::abs(solve_impact_explicit(damped, options).restitution - 0.3) < 1e-9);
        damped.damping.coefficient = explicit_damping(impact, 0.0, options);
        CHECK(solve_impact_explicit(damped, options).outcome == Outcome::capture);
        damped.damping.coefficient *= 1 - 1e-9;
        CHECK(solve_impact_explicit(damped, options).outcome == Outcome::rebound);
    }
}
