// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/scale.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "solver/motion/impact.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

TEST_CASE("the units of the scaled impact: mass, Hertz stiffness and velocity are one") {
    const ContactPair pair = ash(0.3);
    for (const double v : ash_velocities) {
        const Scale scale = Scale::of(pair, v);
        CAPTURE(v);
        CHECK(scale.mass == pair.mass);
        CHECK(scale.velocity == v);
        CHECK(relative_difference(scale.stiffness, 4.0 / 3.0 * 90e9 * std::sqrt(44e-6)) < 1e-15);
        // Force k L^(3/2) is what stops the mass within L: m v^2 = k L^(5/2).
        CHECK(relative_difference(scale.stiffness * std::pow(scale.length, 2.5), pair.mass * v * v) < 1e-14);
        CHECK(relative_difference(scale.force(), scale.stiffness * std::pow(scale.length, 1.5)) < 1e-14);
        CHECK(relative_difference(scale.energy(), pair.mass * v * v) < 1e-15);
        CHECK(relative_difference(scale.momentum(), pair.mass * v) < 1e-15);
        CHECK(relative_difference(scale.time(), scale.length / v) < 1e-15);
        CHECK(relative_difference(scale.radius_length, std::sqrt(44e-6 * scale.length)) < 1e-15);
    }
    // At 2 m/s: L = (9.277e-10 * 4/7.96e8)^0.4 m; the greatest overlap of the reference impact is 1.093 L.
    CHECK(relative_difference(Scale::of(pair, 2.0).length * std::pow(1.25, 0.4), 1.2770060733e-7) < 1e-10);
}

TEST_CASE("the contact time of Hertz is that of the solver, and Johnson's closed form") {
    const ContactPair pair = ash(0.0);
    const double scaled =
        2 * std::pow(1.25, 0.4) * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9);
    for (const double v : ash_velocities) {
        CAPTURE(v);
        const double time = hertz_contact_time(pair, v);
        CHECK(relative_difference(time, scaled * Scale::of(pair, v).time()) < 1e-14);
        const ImpactResult impact =
            solve_impact({Law::of<Hertz>(), Detachment::zero_overlap, {DampingLaw::constant, 0.0}, pair, v});
        CHECK(relative_difference(time, impact.contact_time.value()) < 1e-12);
    }
}

TEST_CASE(
    "scaled damping: beta = eta m^(-3/5) k^(-2/5) v^(-1/5), and every law's number is its own inverse's") {
    const ContactPair pair = ash(0.0);
    for (const double v : ash_velocities) {
        const Scale scale = Scale::of(pair, v);
        const double eta = 0.0153;
        const double beta =
            eta * std::pow(pair.mass, -0.6) * std::pow(scale.stiffness, -0.4) * std::pow(v, -0.2);
        CHECK(relative_difference(scale.damping_number({DampingLaw::constant, eta}), beta) < 1e-14);
        for (const DampingLaw law : all_values<DampingLaw>) {
            const double number = 0.37;
            const double back = scale.damping_number({law, scale.damping_coefficient(law, number)});
            CHECK(relative_difference(back, number) < 1e-15);
        }
    }
}

TEST_CASE("the three damping laws are the same damping where contact radius and overlap are their units") {
    // At delta = L the contact radius is sqrt(R L): eta = C, C a and C sqrt(m k) delta^(1/4) then agree.
    const ContactPair pair = ash(0.0);
    const Scale scale = Scale::of(pair, 2.0);
    const double number = 0.6;
    const double constant = scale.damping_coefficient(DampingLaw::constant, number);
    const double by_radius = scale.damping_coefficient(DampingLaw::contact_radius, number) *
                             std::sqrt(pair.effective_radius * scale.length);
    const double by_tsuji = scale.damping_coefficient(DampingLaw::tsuji, number) *
                            std::sqrt(pair.mass * scale.stiffness) * std::pow(scale.length, 0.25);
    CHECK(relative_difference(by_radius, constant) < 1e-14);
    CHECK(relative_difference(by_tsuji, constant) < 1e-14);
}
