// SPDX-License-Identifier: GPL-3.0-or-later

// Orbits of a law without memory cannot cross: faster in is faster out, and more damping is less of it.
#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/static_curve.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// first, first * factor, ... below @p end.
std::vector<double> geometric(double first, double factor, double end) {
    std::vector<double> values{first};
    while (values.back() * factor < end) values.push_back(values.back() * factor);
    return values;
}

Impact hertz_of(Impact impact) {
    impact.law = Law::of<Hertz>();
    if (impact.detachment != Detachment::zero_force) impact.detachment = Detachment::zero_overlap;
    return impact;
}

/// The largest relative difference of restitution, times and overlap.
double difference(const ImpactResult& a, const ImpactResult& b) {
    return std::max({relative_difference(a.restitution, b.restitution),
                     relative_difference(a.contact_time.value(), b.contact_time.value()),
                     relative_difference(a.approach_time.value(), b.approach_time.value()),
                     relative_difference(a.maximum_overlap, b.maximum_overlap)});
}

}  // namespace

TEST_CASE(
    "a faster impact rebounds faster, goes deeper and, with damping from first touch, keeps more of its "
    "velocity") {
    for (const ContactCase& c : elastic_cases()) {
        CAPTURE(name_of(c));
        Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
        ImpactResult before{};
        int rebounds = 0;
        for (impact.velocity = 0.02; impact.velocity < 50.0; impact.velocity *= 1.25) {
            CAPTURE(impact.velocity);
            const ImpactResult now = solved(impact);
            CHECK(now.maximum_overlap >= before.maximum_overlap);
            if (now.outcome == Outcome::capture) {
                CHECK(before.restitution == 0.0);  // captured below, rebounding above, never the other way
                CHECK(now.restitution == 0.0);
            } else {
                ++rebounds;
                CHECK(now.restitution > 0.0);
                CHECK(now.restitution < 1.0);
                CHECK(now.rebound_velocity > before.rebound_velocity);
                if (!vanishes_at_touch(c.damping_law)) CHECK(now.restitution > before.restitution);
            }
            before = now;
        }
        CHECK(rebounds > 5);
    }
}

TEST_CASE("more damping: less restitution, less overlap, a later end") {
    for (const ContactCase& c : contact_cases()) {
        for (const double w : ash_adhesions) {
            ImpactResult before = solved(impact_of(c, ash(w), 0.0, 2.0));
            for (const double number : geometric(0.01, 1.3, 3.0)) {
                const ImpactResult now = solved(impact_of(c, ash(w), number, 2.0));
                CAPTURE(name_of(c));
                CAPTURE(w);
                CAPTURE(number);
                CHECK(now.maximum_overlap < before.maximum_overlap);
                if (now.outcome == Outcome::capture) {
                    CHECK(now.restitution == 0.0);
                    before = now;
                    continue;
                }
                REQUIRE(before.outcome == Outcome::rebound);
                CHECK(now.restitution < before.restitution);
                if (c.detachment != Detachment::zero_force) CHECK(*now.contact_time > *before.contact_time);
                before = now;
            }
        }
    }
}

TEST_CASE("critical velocity rises with damping, and once every impact is captured it stays so") {
    for (const ContactCase& c : elastic_cases()) {
        for (const double w : ash_adhesions) {
            double before = 0.0;
            bool always = false;
            for (const double number : geometric(0.01, 1.5, 8.0)) {
                const Impact impact = impact_of(c, ash(w), number, 2.0);
                const CriticalVelocity now = critical_of(impact);
                CAPTURE(describe(impact));
                if (always) CHECK(now.verdict == CaptureVerdict::always_captured);
                always = now.verdict == CaptureVerdict::always_captured;
                if (now.verdict == CaptureVerdict::never_captured) CHECK(before == 0.0);
                if (now.verdict == CaptureVerdict::finite) {
                    CHECK(*now.value > before);
                    before = *now.value;
                }
            }
        }
    }
}

// Without adhesion every law is Hertz; with ever less of it every law tends to Hertz.

TEST_CASE("an impact without adhesion is that of Hertz") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        for (const double v : ash_velocities) {
            for (const double number : damping_numbers) {
                const Impact impact = impact_of(c, ash(0.0), number, v);
                worst.see(difference(solved(impact), solved(hertz_of(impact))), describe(impact));
            }
        }
    }
    CHECK(worst.count() == static_cast<int>(elastic_cases().size()) * 9);
    CHECK_MESSAGE(worst.deviation() < 1e-14, worst.where());
}

TEST_CASE("an impact tends to that of Hertz as adhesion vanishes, at least with its square root") {
    Worst last;
    Worst decline;
    for (const ContactCase& c : elastic_cases()) {
        const auto distance = [&](double w) {
            const Impact impact = impact_of(c, ash(w), 0.3, 2.0);
            return difference(solved(impact), solved(hertz_of(impact)));
        };
        for (int power = -4; power > -13; power -= 2) {
            const double w = std::pow(10.0, power);
            const double before = distance(w);
            // A hundredth of the adhesion leaves a tenth of the difference, until that is rounding.
            if (before > 1e-12) decline.see(distance(w / 100) / before, name_of(c));
        }
        last.see(distance(1e-14), name_of(c));
    }
    CHECK_MESSAGE(decline.deviation() < 0.11, decline.where());
    CHECK_MESSAGE(last.deviation() < 2e-8, last.where());
}

TEST_CASE("the static force tends to that of Hertz as adhesion vanishes") {
    const double overlap = 1.3e-7;
    const double hertz = StaticCurve(Law::of<Hertz>(), ash(0.3)).at_overlap(overlap).force();
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const auto distance = [&](double w) {
            return relative_difference(StaticCurve(Law::at(i), ash(w)).at_overlap(overlap).force(), hertz);
        };
        CAPTURE(Law::at(i).name());
        CHECK(distance(0.0) < 1e-15);
        CHECK(distance(1e-8) <= std::max(0.11 * distance(1e-6), 1e-13));
        CHECK(distance(1e-12) < 1e-6);
    }
}
