// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using test::relative_difference;

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
