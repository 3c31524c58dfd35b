// SPDX-License-Identifier: GPL-3.0-or-later
// Without adhesion every law is Hertz; with ever less of it every law tends to Hertz.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "solver/contact/static_curve.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

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
