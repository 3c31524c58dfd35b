// SPDX-License-Identifier: GPL-3.0-or-later
// JKR without damping: the dynamic solver against the analytic separation energy (Eqs. 28-30, exact
// constants).
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double density = 2600.0;  // of ash()

struct End {
    Detachment detachment;
    Separation separation;
};
constexpr End ends[] = {{Detachment::pull_off, Separation::pull_off},
                        {Detachment::load_controlled, Separation::load_controlled}};

double analytic_velocity(double w, Separation separation) {
    return separation_velocity({.work_of_adhesion = w,
                                .effective_radius = ash(w).effective_radius,
                                .contact_modulus = ash(w).contact_modulus},
                               density, separation);
}

}  // namespace

TEST_CASE("undamped JKR impacts rebound with e = sqrt(1 - (v_s/v)^2)") {
    Worst worst;
    for (const End& end : ends) {
        for (const double w : ash_adhesions) {
            const double v_s = analytic_velocity(w, end.separation);
            for (const double ratio : {1.0001, 1.01, 1.5, 3.0, 10.0, 1000.0}) {
                const Impact impact = impact_of({Law::of<Jkr>(), DampingLaw::constant, end.detachment},
                                                ash(w), 0.0, ratio * v_s);
                const double expected = std::sqrt((1.0 - 1.0 / ratio) * (1.0 + 1.0 / ratio));
                worst.see(std::abs(solved(impact).restitution - expected), describe(impact));
            }
        }
    }
    CHECK(worst.count() == 36);
    CHECK_MESSAGE(worst.deviation() < 1e-10, worst.where());
}

TEST_CASE("the dynamic critical velocity of undamped JKR is the analytic v_s to rounding") {
    for (const End& end : ends) {
        for (const double w : ash_adhesions) {
            const CriticalVelocity critical = critical_velocity({Law::of<Jkr>(), end.detachment, {}, ash(w)});
            REQUIRE(critical.value);
            CHECK(relative_difference(*critical.value, analytic_velocity(w, end.separation)) < 1e-14);
            CHECK(critical.dissipated == 0.0);
        }
    }
}

TEST_CASE("the break costs 7.092196 or, at the largest tension, 3.502602 (w^5 R^4/E*^2)^(1/3)") {
    const ContactPair pair = ash(0.3);
    const double unit = std::cbrt(std::pow(0.3, 5) * std::pow(44e-6, 4) / (90e9 * 90e9));
    const auto constant = [&](Detachment detachment) {
        return critical_velocity({Law::of<Jkr>(), detachment, {}, pair}).detachment_energy / unit;
    };
    const double five_thirds = std::pow(std::numbers::pi, 5.0 / 3.0);
    CHECK(relative_difference(constant(Detachment::pull_off), 7.0921959718639584) < 1e-14);
    CHECK(relative_difference(constant(Detachment::pull_off),
                              five_thirds * (6.0 * std::pow(2.0, 2.0 / 3.0) + 1.0) / 10.0) < 1e-14);
    CHECK(relative_difference(constant(Detachment::load_controlled), 3.5026019718352908) < 1e-14);
    CHECK(constant(Detachment::zero_overlap) == 0.0);
}
