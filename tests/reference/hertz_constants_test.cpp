// SPDX-License-Identifier: GPL-3.0-or-later
// Constants of the Hertz impact, at fly-ash scale.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr ContactCase hertz{Law::of<Hertz>(), DampingLaw::constant, Detachment::zero_overlap};

double critical_with(double damping) {
    return critical_velocity({hertz.law, hertz.detachment, {DampingLaw::constant, damping}, ash(0.0)})
        .value.value();
}

/// m^3 k^2/eta^5 [s/m].
double constant_unit(double damping) {
    const double k = hertz_stiffness(ash(0.0));
    return std::pow(ash(0.0).mass, 3) * k * k / std::pow(damping, 5);
}

}  // namespace

TEST_CASE("elastic impact: overlap (5/4)^(2/5), contact time 3.21806546 in units of delta0 and delta0/v") {
    const double k = 4.0 / 3.0 * 90e9 * std::sqrt(44e-6);
    // Time by Hertz 1881: 2 (5/4)^(2/5) times the integral of (1 - x^(5/2))^(-1/2), a beta function.
    const double beta = std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
    const double time_constant = 2.0 * std::pow(1.25, 0.4) * 0.4 * beta;
    CHECK(std::abs(time_constant - 3.21806546) < 5e-9);
    CHECK(std::abs(std::pow(1.25, 0.4) - 1.09336207) < 5e-9);
    for (const double v : ash_velocities) {
        const ImpactResult result = solve_impact(impact_of(hertz, ash(0.0), 0.0, v));
        const double delta0 = std::pow(ash(0.0).mass * v * v / k, 0.4);
        CAPTURE(v);
        CHECK(relative_difference(result.maximum_overlap, std::pow(1.25, 0.4) * delta0) < 1e-14);
        CHECK(relative_difference(result.contact_time.value(), time_constant * delta0 / v) < 1e-14);
        CHECK(relative_difference(result.approach_time.value(), 0.5 * time_constant * delta0 / v) < 1e-14);
        CHECK(std::abs(result.restitution - 1.0) < 1e-15);
    }
}

TEST_CASE("v_c = 0.5476175 eta^5/(m^3 k^2); d ln v_c/d ln eta = 5") {
    for (const double damping : {0.005, 0.0153, 0.07}) {
        const double constant = critical_with(damping) * constant_unit(damping);
        CAPTURE(damping);
        CHECK(relative_difference(constant, 0.5476175) < 1e-6);
        // 30 digits arithmetic: Taylor series from the end of contact back to first touch.
        CHECK(relative_difference(constant, 0.54761752963804861) < 1e-13);
        CHECK(relative_difference(constant, hertz_critical_constant) < 1e-13);
        CHECK(relative_difference(critical_with(1.01 * damping) / critical_with(damping), std::pow(1.01, 5)) <
              1e-13);
    }
}

TEST_CASE("capture from beta = 1.1279881 on, where the impact ends at zero overlap") {
    for (const double v : ash_velocities) {
        CAPTURE(v);
        const double critical = 1.12798813552017;
        CHECK(solve_impact(impact_of(hertz, ash(0.0), critical * (1 - 1e-12), v)).outcome ==
              Outcome::rebound);
        CHECK(solve_impact(impact_of(hertz, ash(0.0), critical * (1 + 1e-12), v)).outcome ==
              Outcome::capture);
    }
}

TEST_CASE("Tsuji's damping makes the Hertz impact a linear oscillator: e = exp(-pi zeta/sqrt(1 - zeta^2))") {
    for (const double zeta : {0.01, 0.1, 0.5, 0.9, 0.99}) {
        const Impact impact = impact_of({Law::of<Hertz>(), DampingLaw::tsuji, Detachment::zero_overlap},
                                        ash(0.0), zeta * std::sqrt(5.0), 2.0);
        CAPTURE(zeta);
        CHECK(relative_difference(solve_impact(impact).restitution,
                                  std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta))) < 1e-12);
    }
}
