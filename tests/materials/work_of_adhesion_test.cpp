// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

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

}  // namespace ashimpact::test
