// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/static_curve.hpp"
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

TEST_CASE("inequalities 44 and 45: without adhesion both hold; with strong adhesion 44 fails, 45 does not") {
    const auto momentum_excess = [](const Impact& impact, const ImpactResult& r) {
        return 2.0 * impact.damping.coefficient * r.maximum_overlap -
               impact.contact.mass * (impact.velocity - r.rebound_velocity);
    };
    bool fails = false;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        if (impact.damping.law != DampingLaw::constant) return;
        CAPTURE(describe(impact));
        if (impact.detachment == Detachment::zero_force) return;
        CHECK(*result.contact_time - *result.approach_time > *result.approach_time);
        const bool bare = result.energy.minimum == 0.0;
        if (bare) CHECK(momentum_excess(impact, result) > 0.0);
    });
    // A weakly damped impact near capture by adhesion, where the attraction slows the rebound.
    for (const ContactCase& c : undamped_cases()) {
        const Impact impact = impact_of(c, ash(1.0), 0.02, 0.3);
        const ImpactResult result = solve_impact(impact);
        if (result.outcome == Outcome::rebound) fails = fails || momentum_excess(impact, result) < 0.0;
    }
    CHECK(fails);
}

TEST_CASE("contact radius and forces of a trajectory are those of the static law") {
    Worst worst;
    for_each_rebound([&](const Impact& impact, const ImpactResult& result) {
        const StaticCurve curve(impact.law, impact.contact);
        for (const TrajectoryPoint& p : trajectory(impact, 9)) {
            if (p.contact_radius <= curve.first().contact_radius) continue;
            const StaticPoint expected = curve.at_contact_radius(p.contact_radius);
            const double size = expected.repulsive_force - expected.attractive_force;
            worst.see(std::abs(p.overlap - expected.overlap) / result.maximum_overlap, describe(impact));
            worst.see(std::abs(p.repulsive_force - expected.repulsive_force) / size, describe(impact));
            worst.see(std::abs(p.attractive_force - expected.attractive_force) / size, describe(impact));
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
        CHECK(greatest > 0.99 * result.maximum_overlap);
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
