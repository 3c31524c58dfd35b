// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

constexpr AdhesiveContact ash_on_steel{
    .work_of_adhesion = 0.3, .effective_radius = 44e-6, .contact_modulus = 89.77e9};
constexpr double density = 2160;

/// JKR force [N] and overlap [m] at a contact radius, in the form of Maugis 2000, Eqs. 4.87 and 4.88.
struct JkrPoint {
    double overlap;
    double force;
};

JkrPoint jkr(const AdhesiveContact& c, double a) {
    const double pi = std::numbers::pi;
    const double overlap =
        a * a / c.effective_radius - std::sqrt(2 * pi * c.work_of_adhesion * a / c.contact_modulus);
    const double force = 4 * c.contact_modulus * a * a * a / (3 * c.effective_radius) -
                         std::sqrt(8 * pi * c.work_of_adhesion * c.contact_modulus * a * a * a);
    return {overlap, force};
}

/// Work of the force from first touch to an end, by Simpson's rule in sqrt(a), in which both are polynomials.
double work_by_quadrature(const AdhesiveContact& c, double end_cubed) {
    const double scale = std::cbrt(std::numbers::pi * c.work_of_adhesion * c.effective_radius *
                                   c.effective_radius / (4.0 / 3.0 * c.contact_modulus));
    const double from = std::sqrt(std::cbrt(8.0 / 3.0) * scale);
    const double to = std::sqrt(std::cbrt(end_cubed) * scale);
    const int steps = 2000;
    const double h = (to - from) / steps;
    const auto integrand = [&](double u) {
        const double slope = 4 * u * u * u / c.effective_radius -
                             std::sqrt(2 * std::numbers::pi * c.work_of_adhesion / c.contact_modulus);
        return jkr(c, u * u).force * slope;
    };
    double sum = integrand(from) + integrand(to);
    for (int i = 1; i < steps; ++i) sum += integrand(from + i * h) * (i % 2 ? 4 : 2);
    return sum * h / 3;
}

}  // namespace

TEST_CASE("the exact constants are the JKR energy between first touch and the end of contact") {
    CHECK(relative_difference(separation_energy_constant(Separation::pull_off), 7.0921959718639584) < 1e-14);
    CHECK(relative_difference(separation_energy_constant(Separation::load_controlled), 3.5026019718352908) <
          1e-14);
    CHECK(relative_difference(separation_velocity_constant(Separation::pull_off), 1.8401831807990565) <
          1e-14);
    CHECK(relative_difference(separation_energy(ash_on_steel), work_by_quadrature(ash_on_steel, 1.0 / 6)) <
          1e-12);
    CHECK(relative_difference(separation_energy(ash_on_steel, Separation::load_controlled),
                              work_by_quadrature(ash_on_steel, 1.5)) < 1e-12);
}

TEST_CASE("breaking at the largest tension instead of the fold costs a factor 1.42 in velocity") {
    const double ratio = separation_velocity(ash_on_steel, density) /
                         separation_velocity(ash_on_steel, density, Separation::load_controlled);
    CHECK(relative_difference(ratio, 1.42296746) < 1e-7);
}

TEST_CASE("the analytic velocity is the one whose kinetic energy is the separation energy") {
    const double v = separation_velocity(ash_on_steel, density);
    const double m = sphere_mass(ash_on_steel.effective_radius, density);
    CHECK(relative_difference(0.5 * m * v * v, separation_energy(ash_on_steel)) < 1e-14);
    const double by_formula =
        separation_velocity_constant(Separation::pull_off) * std::pow(0.3 / 44e-6, 5.0 / 6) /
        std::pow(std::pow(density, 3) * std::pow(ash_on_steel.contact_modulus, 2), 1.0 / 6);
    CHECK(relative_difference(v, by_formula) < 1e-13);
}

TEST_CASE("the paper's rounded constants stay within their rounding of the exact ones") {
    CHECK(relative_difference(dong2013::separation_energy(ash_on_steel) / separation_energy(ash_on_steel),
                              7.09 / 7.0921959718639584) < 1e-13);
    const double v = separation_velocity(ash_on_steel, density);
    CHECK(relative_difference(dong2013::separation_velocity(ash_on_steel, density) / v,
                              1.84 / 1.8401831807990565) < 1e-13);
    const double by_mass = dong2013::separation_velocity_from_mass(
        ash_on_steel, sphere_mass(ash_on_steel.effective_radius, density));
    CHECK(relative_difference(by_mass / v, std::sqrt(14.18 / (2 * 7.0921959718639584))) < 1e-13);
    CHECK(relative_difference(dong2013::separation_velocity(ash_on_steel, density) / by_mass, 1 + 5.5e-5) <
          1e-6);
}

TEST_CASE("scaling with adhesion, radius, modulus and density") {
    AdhesiveContact scaled = ash_on_steel;
    scaled.work_of_adhesion *= 8;
    scaled.effective_radius *= 27;
    scaled.contact_modulus *= 64;
    CHECK(relative_difference(separation_energy(scaled) / separation_energy(ash_on_steel),
                              std::pow(8, 5.0 / 3) * std::pow(27, 4.0 / 3) / 16) < 1e-13);
    CHECK(relative_difference(separation_velocity(ash_on_steel, 4 * density),
                              separation_velocity(ash_on_steel, density) / 2) < 1e-14);
    AdhesiveContact bare = ash_on_steel;
    bare.work_of_adhesion = 0;
    CHECK(separation_energy(bare) == 0);
    CHECK(separation_velocity(bare, density) == 0);
}

TEST_CASE("Tabor's parameter of fly ash on steel lies between the DMT and the JKR limit") {
    // (44e-6 * 0.09/(8.0586529e21 * 6.4e-29))^(1/3) with z0 = 0.4 nm
    CHECK(relative_difference(tabor_parameter(ash_on_steel, 0.4e-9), 1.9728054) < 1e-7);
}

TEST_CASE("impossible contacts are refused") {
    AdhesiveContact wrong = ash_on_steel;
    wrong.work_of_adhesion = -0.1;
    CHECK_THROWS_AS(static_cast<void>(separation_energy(wrong)), InputError);
    wrong = ash_on_steel;
    wrong.contact_modulus = 0;
    CHECK_THROWS_AS(static_cast<void>(separation_velocity(wrong, density)), InputError);
    CHECK_THROWS_AS(static_cast<void>(separation_velocity(ash_on_steel, 0)), InputError);
    CHECK_THROWS_AS(static_cast<void>(tabor_parameter(ash_on_steel, 0)), InputError);
    CHECK_THROWS_AS(static_cast<void>(dong2013::separation_velocity_from_mass(ash_on_steel, -1)), InputError);
    CHECK_THROWS_AS(static_cast<void>(dong2013::separation_velocity(ash_on_steel, -1)), InputError);
}

}  // namespace ashimpact::test
