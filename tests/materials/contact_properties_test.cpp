// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/contact_properties.hpp"

#include <limits>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ElasticBody ash{.young_modulus = 148.126e9, .poisson_ratio = 0.23};
constexpr ElasticBody steel{.young_modulus = 193e9, .poisson_ratio = 0.29};

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
    CHECK(relative_difference(particle_share_of_compliance(ash, contact_modulus(ash, RigidWall{})), 1) <
          1e-15);
}

TEST_CASE("the particle's share of the compliance is the logarithmic derivative of E*") {
    const double h = 1e-5;
    ElasticBody up = ash;
    ElasticBody down = ash;
    up.young_modulus *= 1 + h;
    down.young_modulus *= 1 - h;
    const double value = contact_modulus(ash, steel);
    const double difference = (contact_modulus(up, steel) - contact_modulus(down, steel)) / (2 * h * value);
    CHECK(relative_difference(particle_share_of_compliance(ash, value), difference) < 1e-9);
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

}  // namespace ashimpact::test
