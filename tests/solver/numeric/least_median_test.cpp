// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/numeric/least_median.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/support/random.hpp"

using namespace ashimpact;

TEST_CASE("a least-median fit passes by two fifths of the points, whatever they say") {
    test::Random random(3);
    for (int round = 0; round < 20; ++round) {
        constexpr Eigen::Index count = 50;
        Eigen::MatrixXd design(count, 3);
        Eigen::VectorXd observed(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const double x = random.uniform(0.0, 1.0);
            design.row(i) << 1.0, x, x * x;
            observed[i] = 2.0 - 3.0 * x + 1.5 * x * x + random.normal(0.01);
            if (i % 5 < 2) observed[i] = random.uniform(5.0, 20.0);
        }
        const auto found = least_median(design, observed, [](const auto&) { return true; });
        REQUIRE(found);
        for (const double x : {0.0, 0.5, 1.0})
            CHECK(std::abs((*found)[0] + (*found)[1] * x + (*found)[2] * x * x - 2.0 + 3.0 * x -
                           1.5 * x * x) < 0.15);
    }
}

TEST_CASE("a least-median fit is one that is allowed, and none of rows that are alike") {
    const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(9, 2);
    CHECK_FALSE(least_median(ones, Eigen::VectorXd::Ones(9), [](const auto&) { return true; }));
    Eigen::MatrixXd design(4, 1);
    design << 1.0, 1.0, 1.0, 1.0;
    const Eigen::VectorXd observed = Eigen::Vector4d(1.0, 1.0, 1.0, 7.0);
    const auto most = least_median(design, observed, [](const auto&) { return true; });
    REQUIRE(most);
    CHECK(std::abs((*most)[0] - 1.0) < 1e-15);
    const auto allowed = least_median(design, observed, [](const auto& c) { return c[0] > 2.0; });
    REQUIRE(allowed);
    CHECK(std::abs((*allowed)[0] - 7.0) < 1e-14);
}
