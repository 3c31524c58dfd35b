// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "solver/statistics/importance_sampling.hpp"

using namespace ashimpact;

TEST_CASE("quantiles of weighted values lie on lines between the middles of their weights") {
    const MarginalSample sample({{3.0, 0.25}, {0.0, 0.25}, {1.0, 0.5}});
    // Middles of the weights: 0.125, 0.5 and 0.875.
    CHECK(sample.quantile(0.01) == 0.0);
    CHECK(sample.quantile(0.125) == 0.0);
    CHECK(sample.quantile(0.3125) == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(sample.quantile(0.5) == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(sample.quantile(0.6875) == doctest::Approx(2.0).epsilon(1e-15));
    CHECK(sample.quantile(0.99) == 3.0);
    CHECK(sample.mean() == doctest::Approx(1.25).epsilon(1e-15));
    CHECK(sample.standard_deviation() == doctest::Approx(std::sqrt(1.1875)).epsilon(1e-15));
}
