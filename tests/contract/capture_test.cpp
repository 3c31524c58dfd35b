// The critical velocity parts capture from rebound, to nine digits, for every law; so do the verdicts.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "solver/critical_velocity.hpp"
#include "solver/scale.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// How much deeper than the kinetic energy the adhesive well may be for nine digits to be told apart.
constexpr double greatest_depth = 1e6;

CriticalVelocity critical_of(const Impact& impact) {
    return critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
}

/// The same impact at another velocity, damping coefficient and all.
ImpactResult at_velocity(Impact impact, double velocity) {
    impact.velocity = velocity;
    return solve_impact(impact);
}

/// Checks the verdict on the damping of @p impact by impacts; returns whether nine digits were in reach.
bool check_verdict(const Impact& impact) {
    CAPTURE(describe(impact));
    const CriticalVelocity critical = critical_of(impact);
    if (critical.verdict != CaptureVerdict::finite) {
        CHECK(!critical.value);
        const bool always = critical.verdict == CaptureVerdict::always_captured;
        for (double factor = 1e-6; factor < 2e6; factor *= 100) {
            const ImpactResult result = at_velocity(impact, factor * impact.velocity);
            CHECK((result.outcome == Outcome::capture) == always);
        }
        return false;
    }
    REQUIRE(critical.value);
    CHECK(*critical.value > 0.0);
    const ImpactResult below = at_velocity(impact, *critical.value * (1.0 - 1e-9));
    const ImpactResult above = at_velocity(impact, *critical.value * (1.0 + 1e-9));
    if (std::abs(above.energy.minimum) > greatest_depth * above.energy.incident) return false;
    CHECK(below.outcome == Outcome::capture);
    CHECK(above.outcome == Outcome::rebound);
    CHECK(above.restitution < 1e-3);
    // All that the impact brought was dissipated, or spent on the break.
    const double kinetic = 0.5 * impact.contact.mass * *critical.value * *critical.value;
    CHECK(std::abs(critical.dissipated + critical.detachment_energy - kinetic) < 1e-12 * kinetic);
    CHECK(std::abs(*critical.maximum_overlap - above.maximum_overlap) < 1e-8 * above.maximum_overlap);
    return true;
}

Impact random_impact(Random& random, const ContactCase& c) {
    const double radius = random.log_uniform(1e-7, 1e-3);
    const double density = random.log_uniform(500.0, 2e4);
    const ContactPair pair{.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density,
                           .effective_radius = radius,
                           .contact_modulus = random.log_uniform(1e8, 1e12),
                           .work_of_adhesion = random.log_uniform(1e-4, 10.0)};
    const double velocity = random.log_uniform(1e-4, 1e3);
    return impact_of(c, pair, random.log_uniform(1e-3, 3.0), velocity);
}

}  // namespace

TEST_CASE("capture just below and rebound just above the critical velocity, at fly-ash scale") {
    int reached = 0;
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            for (const double number : {1e-4, 0.02, 0.3, 1.2, 3.0}) {
                reached += check_verdict(impact_of(c, ash(w), number, 2.0)) ? 1 : 0;
            }
        }
    }
    CHECK(reached > 100);
}

TEST_CASE("capture just below and rebound just above the critical velocity, anywhere") {
    Random random(20131);
    int reached = 0;
    const int times = repetitions(200);
    for (const ContactCase& c : contact_cases()) {
        for (int i = 0; i < times; ++i) reached += check_verdict(random_impact(random, c)) ? 1 : 0;
    }
    CHECK(reached > 5 * times);
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

TEST_CASE("where the arrival takes a finite time, impacts just above the critical velocity end then") {
    int seen = 0;
    for (const ContactCase& c : contact_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        const CriticalVelocity critical = critical_of(impact);
        if (!critical.contact_time) continue;
        ++seen;
        CAPTURE(name_of(c));
        // The particle is late by v_r/acceleration, and v_r is the root of the excess.
        const auto lateness = [&](double excess) {
            const ImpactResult above = at_velocity(impact, *critical.value * (1.0 + excess));
            return std::abs(above.contact_time.value() / *critical.contact_time - 1.0);
        };
        CHECK(lateness(1e-8) < 0.011 * lateness(1e-4));
        CHECK(lateness(1e-12) < 2e-5);
    }
    CHECK(seen >= 3);
}
