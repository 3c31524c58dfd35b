// SPDX-License-Identifier: GPL-3.0-or-later
// Where there is no critical velocity, and the thresholds between, as derived for each damping law.
#include <cmath>

#include <doctest/doctest.h>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/scale.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

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
