// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "solver/numeric/interpolation.hpp"

using namespace ashimpact;

TEST_CASE(
    "inverse interpolation keeps every point until it is full, even where zero is nearer to the wanted "
    "value") {
    InverseInterpolation<3> parabola(0.1);  // x = f^2 is its own interpolation through three points
    for (const double f : {1.0, 0.9, 0.8}) parabola.insert({.value = f, .x = f * f});
    CHECK(parabola.count() == 3);
    CHECK(parabola.nearest().value == 0.8);
    CHECK(parabola.interpolated() == doctest::Approx(0.01).epsilon(1e-13));
}

TEST_CASE("inverse interpolation that is full drops the point farthest from the wanted value") {
    InverseInterpolation<2> line(1.0);
    for (const double f : {0.7, 3.0, 1.2, 2.0}) line.insert({.value = f, .x = 10.0 * f});
    line.insert({.value = 5.0, .x = 0.0});  // is the farthest itself
    CHECK(line.count() == 2);
    CHECK(line.nearest().value == 1.2);
    CHECK(line.interpolated() == doctest::Approx(10.0).epsilon(1e-13));
}

TEST_CASE("an interval is open where no bound is known") {
    InverseInterpolation<2> search(1.0);
    CHECK(search.contains(1e300));
    search.bound(2.0, true);
    search.bound(5.0, false);
    CHECK_FALSE(search.contains(2.0));
    CHECK(search.contains(3.0));
    CHECK_FALSE(search.contains(5.0));
    CHECK(search.lower() == 2.0);
    CHECK(search.upper() == 5.0);
}
