// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/contact_properties.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ElasticBody ash{.young_modulus = 148.126e9, .poisson_ratio = 0.23};
constexpr ElasticBody steel{.young_modulus = 193e9, .poisson_ratio = 0.29};

constexpr AdhesiveContact ash_on_steel{
    .work_of_adhesion = 0.3, .effective_radius = 44e-6, .contact_modulus = 89.77e9};
constexpr double ash_density = 2160;

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

TEST_CASE("contact modulus of fly ash on stainless steel, worked by hand") {
    // (1 - 0.0529)/148.126 + (1 - 0.0841)/193 = 0.0063938809 + 0.0047455959 = 0.0111394768 1/GPa
    CHECK(relative_difference(contact_modulus(ash, steel), 89.770822e9) < 1e-7);
    CHECK(contact_modulus(steel, ash) == contact_modulus(ash, steel));
}

TEST_CASE("a rigid wall is the limit of a stiff one") {
    CHECK(relative_difference(contact_modulus(ash, RigidWall{}), 156.399535e9) < 1e-8);
    const ElasticBody stiff{.young_modulus = 1e25, .poisson_ratio = 0.1};
    CHECK(relative_difference(contact_modulus(ash, stiff), contact_modulus(ash, RigidWall{})) < 1e-12);
}

TEST_CASE("effective radius and mass, and their limits at a flat, fixed wall") {
    CHECK(effective_radius(44e-6, infinity) == 44e-6);
    CHECK(relative_difference(effective_radius(44e-6, 44e-6), 22e-6) < 1e-15);
    CHECK(relative_difference(effective_radius(44e-6, 88e-6), 88e-6 / 3) < 1e-15);
    CHECK(effective_mass(0.93e-9, infinity) == 0.93e-9);
    CHECK(relative_difference(effective_mass(0.93e-9, 2.79e-9), 0.6975e-9) < 1e-15);
}

TEST_CASE("mass of a sphere and back") {
    CHECK(relative_difference(sphere_mass(44e-6, 2600), 9.277265524917621e-10) < 1e-14);
    CHECK(relative_difference(sphere_density(44e-6, sphere_mass(44e-6, 2160)), 2160) < 1e-15);
}

TEST_CASE("impossible bodies are refused by name, value and unit") {
    CHECK_THROWS_WITH_AS(static_cast<void>(sphere_mass(44e-6, -3)),
                         "density is -3 kg/m3; allowed: a positive density [kg/m3]", InputError);
    CHECK_THROWS_AS(static_cast<void>(sphere_mass(0, 2160)), InputError);
    CHECK_THROWS_AS(static_cast<void>(sphere_density(44e-6, infinity)), InputError);
    CHECK_THROWS_AS(static_cast<void>(effective_radius(44e-6, 0)), InputError);
    CHECK_THROWS_AS(static_cast<void>(effective_mass(std::numeric_limits<double>::quiet_NaN(), 1)),
                    InputError);
    CHECK_THROWS_AS(
        static_cast<void>(contact_modulus({.young_modulus = 0, .poisson_ratio = 0.2}, RigidWall{})),
        InputError);
    CHECK_THROWS_WITH_AS(
        static_cast<void>(contact_modulus({.young_modulus = 90e9, .poisson_ratio = 0.51}, RigidWall{})),
        "poisson_ratio is 0.51; allowed: -1 < Poisson ratio <= 0.5", InputError);
    CHECK_THROWS_AS(
        static_cast<void>(contact_modulus({.young_modulus = 90e9, .poisson_ratio = -1}, RigidWall{})),
        InputError);
}

TEST_CASE("the three rules, worked by hand for 0.16 and 0.09 J/m2") {
    const SurfaceEnergies energies{.particle = 0.16, .wall = 0.09};
    CHECK(relative_difference(work_of_adhesion(AdhesionRule::girifalco_good, energies), 0.24) < 1e-15);
    CHECK(relative_difference(work_of_adhesion(AdhesionRule::dong2013, energies), 0.12) < 1e-15);
    const SurfaceEnergies with_interface{.particle = 0.16, .wall = 0.09, .interfacial = 0.07};
    CHECK(relative_difference(work_of_adhesion(AdhesionRule::dupre, with_interface), 0.18) < 1e-15);
}

TEST_CASE(
    "Dupre with the interfacial energy the paper names gives Girifalco and Good, not the paper's result") {
    const double g1 = 0.143;
    const double g2 = 0.071;
    const SurfaceEnergies energies{
        .particle = g1, .wall = g2, .interfacial = g1 + g2 - 2 * std::sqrt(g1 * g2)};
    const double dupre = work_of_adhesion(AdhesionRule::dupre, energies);
    const SurfaceEnergies bare{.particle = g1, .wall = g2};
    CHECK(relative_difference(dupre, work_of_adhesion(AdhesionRule::girifalco_good, bare)) < 1e-14);
    CHECK(relative_difference(dupre, 2 * work_of_adhesion(AdhesionRule::dong2013, bare)) < 1e-14);
}

TEST_CASE("names and back") {
    for (const auto rule : {AdhesionRule::girifalco_good, AdhesionRule::dong2013, AdhesionRule::dupre})
        CHECK(named<AdhesionRule>(name_of(rule)) == rule);
    CHECK_THROWS_WITH_AS(static_cast<void>(named<AdhesionRule>("good")),
                         "no adhesion rule is called \"good\"; allowed: girifalco-good, dong2013, dupre",
                         InputError);
}

TEST_CASE("energies that make no sense are refused") {
    CHECK_THROWS_AS(static_cast<void>(work_of_adhesion(AdhesionRule::dupre, {.particle = 0.1, .wall = 0.1})),
                    InputError);
    CHECK_THROWS_AS(
        static_cast<void>(work_of_adhesion(AdhesionRule::girifalco_good, {.particle = -0.1, .wall = 0.1})),
        InputError);
    CHECK_THROWS_AS(static_cast<void>(work_of_adhesion(AdhesionRule::girifalco_good,
                                                       {.particle = 0.1, .wall = 0.1, .interfacial = 0.1})),
                    InputError);
    CHECK_THROWS_AS(static_cast<void>(work_of_adhesion(AdhesionRule::dupre,
                                                       {.particle = 0.1, .wall = 0.1, .interfacial = 0.3})),
                    InputError);
}

TEST_CASE("roughness leaves smooth surfaces alone and takes most of the adhesion of nanometre asperities") {
    constexpr double radius = 44e-6;
    CHECK(roughness_reduction(radius, {.rms = 0}) == 1);
    double before = 1;
    for (int i = 0; i < 17; ++i) {
        const double rms = 1e-14 * std::pow(2.0, i);
        const double left = roughness_reduction(radius, {.rms = rms});
        CHECK(left < before);
        before = left;
    }
    // 1 nm: 1/(1 + 44e-6/1.48e-9) + 1/(1 + 1.48/0.3)^2, by hand.
    CHECK(relative_difference(roughness_reduction(radius, {.rms = 1e-9}),
                              1.48e-9 / (44e-6 + 1.48e-9) + 0.09 / (1.78 * 1.78)) < 1e-12);
    // Wide asperities are spheres of their own: the adhesion rises again.
    CHECK(roughness_reduction(radius, {.rms = 1e-6}) > roughness_reduction(radius, {.rms = 20e-9}));
    CHECK_THROWS_AS(static_cast<void>(roughness_reduction(radius, {.rms = -1e-9})), InputError);
    CHECK_THROWS_AS(static_cast<void>(roughness_reduction(0, {.rms = 1e-9})), InputError);
}

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
    const double ratio = separation_velocity(ash_on_steel, ash_density) /
                         separation_velocity(ash_on_steel, ash_density, Separation::load_controlled);
    CHECK(relative_difference(ratio, 1.42296746) < 1e-7);
}

TEST_CASE("the analytic velocity is the one whose kinetic energy is the separation energy") {
    const double v = separation_velocity(ash_on_steel, ash_density);
    const double m = sphere_mass(ash_on_steel.effective_radius, ash_density);
    CHECK(relative_difference(0.5 * m * v * v, separation_energy(ash_on_steel)) < 1e-14);
    const double by_formula =
        separation_velocity_constant(Separation::pull_off) * std::pow(0.3 / 44e-6, 5.0 / 6) /
        std::pow(std::pow(ash_density, 3) * std::pow(ash_on_steel.contact_modulus, 2), 1.0 / 6);
    CHECK(relative_difference(v, by_formula) < 1e-13);
}

TEST_CASE("the paper's rounded constants stay within their rounding of the exact ones") {
    CHECK(relative_difference(dong2013::separation_energy(ash_on_steel) / separation_energy(ash_on_steel),
                              7.09 / 7.0921959718639584) < 1e-13);
    const double v = separation_velocity(ash_on_steel, ash_density);
    CHECK(relative_difference(dong2013::separation_velocity(ash_on_steel, ash_density) / v,
                              1.84 / 1.8401831807990565) < 1e-13);
    const double by_mass = dong2013::separation_velocity_from_mass(
        ash_on_steel, sphere_mass(ash_on_steel.effective_radius, ash_density));
    CHECK(relative_difference(by_mass / v, std::sqrt(14.18 / (2 * 7.0921959718639584))) < 1e-13);
    CHECK(relative_difference(dong2013::separation_velocity(ash_on_steel, ash_density) / by_mass,
                              1 + 5.5e-5) < 1e-6);
}

TEST_CASE("scaling with adhesion, radius, modulus and density") {
    AdhesiveContact scaled = ash_on_steel;
    scaled.work_of_adhesion *= 8;
    scaled.effective_radius *= 27;
    scaled.contact_modulus *= 64;
    CHECK(relative_difference(separation_energy(scaled) / separation_energy(ash_on_steel),
                              std::pow(8, 5.0 / 3) * std::pow(27, 4.0 / 3) / 16) < 1e-13);
    CHECK(relative_difference(separation_velocity(ash_on_steel, 4 * ash_density),
                              separation_velocity(ash_on_steel, ash_density) / 2) < 1e-14);
    AdhesiveContact bare = ash_on_steel;
    bare.work_of_adhesion = 0;
    CHECK(separation_energy(bare) == 0);
    CHECK(separation_velocity(bare, ash_density) == 0);
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
    CHECK_THROWS_AS(static_cast<void>(separation_velocity(wrong, ash_density)), InputError);
    CHECK_THROWS_AS(static_cast<void>(separation_velocity(ash_on_steel, 0)), InputError);
    CHECK_THROWS_AS(static_cast<void>(tabor_parameter(ash_on_steel, 0)), InputError);
    CHECK_THROWS_AS(static_cast<void>(dong2013::separation_velocity_from_mass(ash_on_steel, -1)), InputError);
    CHECK_THROWS_AS(static_cast<void>(dong2013::separation_velocity(ash_on_steel, -1)), InputError);
}

}  // namespace ashimpact::test
