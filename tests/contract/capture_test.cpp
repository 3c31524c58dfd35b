// SPDX-License-Identifier: GPL-3.0-or-later

// The critical velocity parts capture from rebound, to nine digits, for every law; so do the verdicts.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/static_curve.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// How much deeper than the kinetic energy the adhesive well may be for nine digits to be told apart.
constexpr double greatest_depth = 1e6;

/// The same impact at another velocity, damping coefficient and all.
ImpactResult at_velocity(Impact impact, double velocity) {
    impact.velocity = velocity;
    return solved(impact);
}

/// A verdict without a critical velocity: captured, or rebounding, at every velocity that keeps the overlap
/// within the theory.
void check_every_velocity(const Impact& impact, CaptureVerdict verdict) {
    for (int power = -6; power <= 6; power += 2) {
        const double velocity = std::pow(10.0, power) * impact.velocity;
        // A return that stiff takes a cohesive zone too many steps; its restitution is below 1e-5.
        if (is_cohesive(impact.law, impact.contact) &&
            Scale::of(impact.contact, velocity).damping_number(impact.damping) > 1e5)
            continue;
        const ImpactResult result = at_velocity(impact, velocity);
        const bool within_theory = result.maximum_overlap < impact.contact.effective_radius;
        if (result.yielded && !within_theory) continue;
        CHECK((result.outcome == Outcome::capture) == (verdict == CaptureVerdict::always_captured));
    }
}

/// Capture and rebound change places at @p velocity. Returns whether nine digits were in reach.
bool check_change(const Impact& impact, double velocity, Outcome outcome_below) {
    const ImpactResult below = at_velocity(impact, velocity * (1.0 - 1e-9));
    const ImpactResult above = at_velocity(impact, velocity * (1.0 + 1e-9));
    if (std::abs(above.energy.minimum) > greatest_depth * above.energy.incident) return false;
    CAPTURE(velocity);
    CHECK(below.outcome == outcome_below);
    CHECK(above.outcome != outcome_below);
    CHECK(std::max(below.restitution, above.restitution) < 1e-3);
    return true;
}

/// Checks the verdict on the damping of @p impact by impacts; returns whether nine digits were in reach.
bool check_verdict(const Impact& impact) {
    CAPTURE(describe(impact));
    const CriticalVelocity critical = critical_of(impact);
    if (critical.verdict != CaptureVerdict::finite) {
        CHECK(!critical.value);
        CHECK(critical.crossings.empty());
        check_every_velocity(impact, critical.verdict);
        return false;
    }
    REQUIRE(critical.value);
    CHECK(*critical.value > 0.0);
    REQUIRE(!critical.crossings.empty());
    CHECK(critical.crossings.front() == *critical.value);
    CHECK(std::is_sorted(critical.crossings.begin(), critical.crossings.end()));
    Outcome below = Outcome::capture;
    for (const double velocity : critical.crossings) {
        if (!check_change(impact, velocity, below)) return false;
        below = below == Outcome::capture ? Outcome::rebound : Outcome::capture;
    }
    // All that the impact brought was dissipated, or spent on yielding and on the break.
    const double kinetic = 0.5 * impact.contact.mass * *critical.value * *critical.value;
    const double spent = critical.dissipated + critical.plastic + critical.detachment_energy;
    CHECK(std::abs(spent - kinetic) < 1e-12 * kinetic);
    const double overlap = at_velocity(impact, *critical.value * (1.0 + 1e-9)).maximum_overlap;
    CHECK(std::abs(*critical.maximum_overlap - overlap) < 1e-8 * overlap);
    return true;
}

Impact random_impact(Random& random, ContactCase c) {
    const ContactPair pair = random_pair(random);
    const double velocity = random.log_uniform(1e-4, 1e3);
    if (std::isfinite(c.yield_pressure))
        c.yield_pressure = pair.contact_modulus * random.log_uniform(1e-3, 1.0);
    return impact_of(c, pair, random.log_uniform(1e-3, 3.0), velocity);
}

/// Checks @p times random verdicts of each case; returns how many were in reach.
int check_random_verdicts(const std::vector<ContactCase>& cases, int times, std::uint64_t seed) {
    int reached = 0;
    for (const ContactCase& c : cases) {
        Random random = random_of(name_of(c), seed);
        for (int i = 0; i < times; ++i) reached += check_verdict(random_impact(random, c)) ? 1 : 0;
    }
    return reached;
}

/// Lowest power of x in p(x), but for rounding.
int lowest_power(const Polynomial<Extended>& p) {
    int power = 0;
    while (power < p.degree && std::abs(p[power]) < 1e-12L) ++power;
    return power;
}

/// Power of the excess over v_c by which the contact is shorter than the critical one: with
/// d(delta) ~ x^d dx and U_end - U ~ x^k at the end, the time integral of x^d dx/sqrt(x^k + excess) misses
/// excess^((d + 1)/k - 1/2). One half where the force at the end is not zero; another power where attraction
/// vanishes with the root of the overlap.
double power_of_lateness(const Impact& impact) {
    const StaticCurve curve(impact.law, impact.contact);
    const StaticPoint end = curve.at_overlap(curve.end_overlap(impact.detachment));
    if (std::abs(end.force()) > 1e-9 * end.repulsive_force - 1e-9 * end.attractive_force) return 0.5;
    const auto motion = scaled_motion<Extended>(impact, Scale::of(impact.contact, impact.velocity));
    Polynomial<Extended> fall = motion.at(*motion.end).potential.shifted(*motion.end);
    fall[0] = 0;
    return (lowest_power(motion.at(*motion.end).slope.shifted(*motion.end)) + 1.0) / lowest_power(fall) - 0.5;
}

CaptureVerdict verdict_of(const ContactCase& c, double w, double coefficient) {
    return critical_velocity({c.law, c.detachment, {c.damping_law, coefficient}, ash(w)}).verdict;
}

/// Coefficient from which on every velocity is captured, by bisection between two verdicts.
double threshold_of(const ContactCase& c, double w, double finite, double always) {
    REQUIRE(verdict_of(c, w, finite) == CaptureVerdict::finite);
    REQUIRE(verdict_of(c, w, always) == CaptureVerdict::always_captured);
    while (always / finite > 1.0 + 1e-9) {
        const double middle = std::sqrt(finite * always);
        (verdict_of(c, w, middle) == CaptureVerdict::finite ? finite : always) = middle;
    }
    return std::sqrt(finite * always);
}

/// Whether a damping law captures every impact from some scaled coefficient on, whatever the velocity.
bool can_overdamp(DampingLaw law) {
    return std::isfinite(overdamped_squared(law));
}

constexpr ContactCase hertz(DampingLaw damping_law, Detachment detachment = Detachment::zero_overlap) {
    return {Law::of<Hertz>(), damping_law, detachment};
}

}  // namespace

TEST_CASE("capture just below and rebound just above the critical velocity, at fly-ash scale") {
    int reached = 0;
    for (const ContactCase& c : elastic_cases()) {
        for (const double w : ash_adhesions) {
            for (const double number : {1e-4, 0.02, 0.3, 1.2, 3.0}) {
                reached += check_verdict(impact_of(c, ash(w), number, 2.0)) ? 1 : 0;
            }
        }
    }
    CHECK(reached > 100);
    for (const ContactCase& c : yielding_cases()) {
        for (const double number : {0.02, 0.8}) CHECK(check_verdict(impact_of(c, ash(0.3), number, 2.0)));
    }
}

TEST_CASE("capture just below and rebound just above the critical velocity, anywhere") {
    const int times = repetitions(80);
    CHECK(check_random_verdicts(elastic_cases(), times, 20131) > 5 * times);
}

TEST_CASE("contacts that yield: every change between capture and rebound, anywhere") {
    const int times = repetitions(6);
    CHECK(check_random_verdicts(yielding_cases(), times, 1998) > times / 2);
}

TEST_CASE("an undamped contact whose break costs energy captures below that energy") {
    int reached = 0;
    for (const ContactCase& c : undamped_cases()) {
        for (const double w : ash_adhesions) {
            reached += check_verdict(impact_of(c, ash(w), 0.0, 2.0)) ? 1 : 0;
        }
    }
    CHECK(reached >= 3);
}

TEST_CASE("where the arrival takes a finite time, impacts ever closer above the critical velocity end then") {
    int seen = 0;
    for (const ContactCase& c : elastic_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const CriticalVelocity critical = critical_of(impact);
        if (!critical.contact_time) continue;
        ++seen;
        CAPTURE(name_of(c));
        const double power = power_of_lateness(impact);
        const double fall = 1.1 * std::pow(1e-4, power);
        const auto lateness = [&](double excess) {
            const ImpactResult above = at_velocity(impact, *critical.value * (1.0 + excess));
            return std::abs(above.contact_time.value() / *critical.contact_time - 1.0);
        };
        CHECK(lateness(1e-8) < fall * lateness(1e-4));
        CHECK(lateness(1e-12) < fall * lateness(1e-8));
    }
    CHECK(seen >= 12);
}

// Where there is no critical velocity, and the thresholds between, as derived for each damping law.

TEST_CASE("without adhesion: never captured undamped, by force, or with contact-radius damping") {
    for (const DampingLaw damping : all_values<DampingLaw>) {
        CAPTURE(name_of(damping));
        CHECK(verdict_of(hertz(damping), 0.0, 0.0) == CaptureVerdict::never_captured);
        for (const double coefficient : {0.001, 1.0, 2.3, 1e4}) {
            CAPTURE(coefficient);
            CHECK(verdict_of(hertz(damping, Detachment::zero_force), 0.0, coefficient) ==
                  CaptureVerdict::never_captured);
        }
    }
    for (const double coefficient : {1e-3, 1.0, 1e5}) {
        CHECK(verdict_of(hertz(DampingLaw::contact_radius), 0.0, coefficient) ==
              CaptureVerdict::never_captured);
        CHECK(verdict_of(hertz(DampingLaw::constant), 0.0, coefficient) == CaptureVerdict::finite);
    }
}

TEST_CASE("undamped contacts that end where they began are never captured") {
    for (const ContactCase& c : undamped_cases()) {
        CAPTURE(name_of(c));
        const CaptureVerdict expected =
            c.detachment == Detachment::zero_overlap || c.detachment == Detachment::zero_force
                ? CaptureVerdict::never_captured
                : CaptureVerdict::finite;
        CHECK(verdict_of(c, 0.3, 0.0) == expected);
    }
}

TEST_CASE("Tsuji's damping without adhesion captures every velocity from sqrt5 on, none below") {
    const double sqrt5 = std::sqrt(5.0);
    CHECK(verdict_of(hertz(DampingLaw::tsuji), 0.0, sqrt5 * (1.0 - 1e-12)) == CaptureVerdict::never_captured);
    CHECK(verdict_of(hertz(DampingLaw::tsuji), 0.0, sqrt5 * (1.0 + 1e-12)) ==
          CaptureVerdict::always_captured);
    for (const double v : {1e-3, 2.0, 300.0}) {
        const auto at = [&](double zeta) {
            return solved(impact_of(hertz(DampingLaw::tsuji), ash(0.0), zeta * sqrt5, v));
        };
        CHECK(at(0.99).outcome == Outcome::rebound);
        CHECK(at(1.0 + 1e-12).outcome == Outcome::capture);
        // A rebound exp(-pi/sqrt(2 (1 - zeta))) slower is none from 1e-100 on, never something undefined.
        for (const double gap : {1e-3, 1e-4, 1e-5, 1e-7, 1e-10, 1e-14}) {
            const ImpactResult near = at(1.0 - gap);
            CAPTURE(gap);
            CHECK((near.outcome == Outcome::rebound) == (gap > 9e-5));
            CHECK(near.restitution >= 0.0);
            CHECK(near.restitution < 1e-30);
        }
    }
}

TEST_CASE(
    "with adhesion, a damping law with a limit captures every velocity beyond it, and has a v_c below") {
    for (const ContactCase& c : elastic_cases()) {
        if (!can_overdamp(c.damping_law) || !c.law.is_adhesive()) continue;
        CAPTURE(name_of(c));
        const double limit = std::sqrt(overdamped_squared(c.damping_law));
        CHECK(verdict_of(c, 0.3, 0.9 * limit) == CaptureVerdict::finite);
        CHECK(verdict_of(c, 0.3, 1.03 * limit) == CaptureVerdict::always_captured);
    }
}

TEST_CASE(
    "contact-radius damping with DMT adhesion: every velocity captured above g A^(1/6) = 1.2005 k^(2/3) "
    "m^(1/2)") {
    const ContactCase c{Law::of<Dmt>(), DampingLaw::contact_radius, Detachment::zero_overlap};
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const double k = hertz_stiffness(pair);
        const double attraction = 2.0 * std::acos(-1.0) * w * pair.effective_radius;
        // eta = C a = g sqrt(delta), so g = C sqrt(R).
        const double unit = std::pow(k, 2.0 / 3.0) * std::sqrt(pair.mass) / std::pow(attraction, 1.0 / 6.0) /
                            std::sqrt(pair.effective_radius);
        const double threshold = threshold_of(c, w, 1.0 * unit, 1.5 * unit) / unit;
        CAPTURE(w);
        CHECK(std::abs(threshold - 1.2005) < 5e-5);
    }
}

TEST_CASE("damping from first touch, with adhesion, always has a finite critical velocity") {
    for (const ContactCase& c : elastic_cases()) {
        if (vanishes_at_touch(c.damping_law) || !c.law.is_adhesive()) continue;
        for (const double w : ash_adhesions) {
            for (const double number : {1e-6, 1e-2, 1.0, 20.0, 1e3}) {
                const Impact impact = impact_of(c, ash(w), number, 2.0);
                CAPTURE(describe(impact));
                CHECK(verdict_of(c, w, impact.damping.coefficient) == CaptureVerdict::finite);
            }
        }
    }
}

TEST_CASE("an approach too damped to turn ends at equilibrium, and has no approach time") {
    const ContactCase c{Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap};
    const ContactPair pair = ash(0.3);
    const double attraction = 2.0 * std::acos(-1.0) * 0.3 * pair.effective_radius;
    const double equilibrium = std::pow(attraction / hertz_stiffness(pair), 2.0 / 3.0);
    for (const double v : {1e-4, 1e-3, 0.01}) {
        CAPTURE(v);
        const ImpactResult result = solved({c.law, c.detachment, {DampingLaw::constant, 0.0153}, pair, v});
        CHECK(result.outcome == Outcome::capture);
        CHECK(!result.approach_time);
        CHECK(!result.contact_time);
        CHECK(relative_difference(result.maximum_overlap, equilibrium) < 1e-14);
    }
    const ImpactResult fast = solved({c.law, c.detachment, {DampingLaw::constant, 0.0153}, pair, 2.0});
    CHECK(fast.approach_time);
    CHECK(fast.maximum_overlap > equilibrium);
}

TEST_CASE("a spiral too tight to turn above rounding ends at equilibrium") {
    // Damping just below the critical one of the equilibrium: it turns e^-50 of the way beyond it.
    for (const ContactCase& c : elastic_cases()) {
        if (!can_overdamp(c.damping_law) || !c.law.is_adhesive()) continue;
        for (int step = 0; step < 75; ++step) {
            const double number = (0.827 + 0.0009 * step) * std::sqrt(overdamped_squared(c.damping_law));
            const Impact impact = impact_of(c, ash(0.3), number, 1e-4);
            CAPTURE(describe(impact));
            const ImpactResult result = solved(impact);
            CHECK(result.outcome == Outcome::capture);
            CHECK(result.steps < 200);
            CHECK(result.maximum_overlap > 0.0);
        }
    }
}
