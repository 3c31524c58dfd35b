#include "solver/regime.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/scale.hpp"
#include "solver/velocity_scales.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/errors.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

Impact impact_with(Law law, double w, double velocity = 2.0) {
    return impact_of({law, DampingLaw::constant, law.default_detachment()}, ash(w), 0.3, velocity);
}

bool warns(const Regime& regime, const std::string& part) {
    return std::any_of(regime.warnings.begin(), regime.warnings.end(),
                       [&](const std::string& warning) { return contains(warning, part); });
}

}  // namespace

TEST_CASE("the numbers of a regime") {
    const Impact impact = impact_with(Law::of<Dmt>(), 0.3);
    const Regime regime = regime_of(impact, 1.1e-7);
    // (R w^2/(E*^2 z0^3))^(1/3) with z0 = 0.4 nm
    const double tabor = std::cbrt(44e-6 * 0.09 / (90e9 * 90e9 * std::pow(0.4e-9, 3)));
    CHECK(relative_difference(regime.tabor_parameter, tabor) < 1e-14);
    CHECK(relative_difference(regime.damping_number, 0.3) < 1e-14);
    CHECK(relative_difference(regime.relative_contact_radius, std::sqrt(1.1e-7 / 44e-6)) < 1e-14);
    const double number = 2.0 * std::acos(-1.0) * 0.3 * 44e-6 * std::pow(ash(0.3).mass, -0.6) *
                          std::pow(hertz_stiffness(ash(0.3)), -0.4) * std::pow(2.0, -1.2);
    CHECK(relative_difference(regime.adhesion_number, number) < 1e-13);
    CHECK(std::isinf(regime.yield_velocity));
    CHECK(regime.warnings.empty());
}

TEST_CASE("a law outside its range is warned about") {
    // Tabor's parameter goes with w^(2/3): 1.97 at 0.3 J/m2.
    CHECK(warns(regime_of(impact_with(Law::of<Dmt>(), 3.0), 1e-7), "JKR applies rather than DMT"));
    CHECK(!warns(regime_of(impact_with(Law::of<Jkr>(), 3.0), 1e-7), "applies"));
    CHECK(warns(regime_of(impact_with(Law::of<Jkr>(), 0.003), 1e-7), "DMT applies rather than JKR"));
    CHECK(!warns(regime_of(impact_with(Law::of<Dmt>(), 0.003), 1e-7), "applies"));
    CHECK(!warns(regime_of(impact_with(Law::of<Jkr>(), 0.0), 1e-7), "applies"));
}

TEST_CASE("yield, large contacts and overlaps beyond the radius are warned about") {
    Impact impact = impact_with(Law::of<Hertz>(), 0.0);
    impact.contact.yield_pressure = 2e9;  // V_y = 0.68 m/s
    CHECK(warns(regime_of(impact, 1e-7), "above the yield velocity 0.676 m/s"));
    impact.law = Law::of<ThorntonNing>();
    CHECK(!warns(regime_of(impact, 1e-7), "yield velocity"));
    impact.velocity = 0.5;
    impact.law = Law::of<Hertz>();
    CHECK(!warns(regime_of(impact, 1e-7), "yield velocity"));
    CHECK(warns(regime_of(impact, 5e-6), "contact radius is 0.337 of the radius"));
    CHECK(warns(regime_of(impact, 45e-6), "overlap exceeds the radius: outside the theory"));
    CHECK(!warns(regime_of(impact, 3.9e-6), "radius"));
}

TEST_CASE("velocities at which damping and adhesion are of order one") {
    const ContactPair pair = ash(0.3);
    const Damping damping{DampingLaw::constant, 0.0153};
    const double v_damping = velocity_of_damping(damping, pair);
    CHECK(relative_difference(Scale::of(pair, v_damping).damping_number(damping), 1.0) < 1e-13);
    CHECK(velocity_of_damping({DampingLaw::tsuji, 1.0}, pair) == 0.0);
    CHECK(velocity_of_damping({DampingLaw::contact_radius, 1e3}, pair) == 0.0);
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const double v = velocity_of_adhesion(Law::at(i), pair);
        CAPTURE(Law::at(i).name());
        CHECK(velocity_of_adhesion(Law::at(i), ash(0.0)) == 0.0);
        if (v == 0.0) continue;
        const double number = Law::at(i).visit<double>([&]<template <class> class L>() {
            return L<double>::adhesion_number(pair, Scale::of(pair, v).length);
        });
        CHECK(relative_difference(number, 1.0) < 1e-12);
    }
}
