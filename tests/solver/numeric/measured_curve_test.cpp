// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Restitution over incident velocity, rising steeply from capture and falling slowly [m/s], [1].
const std::vector<double> velocities{1.92, 2.0, 2.2, 3.1, 5.0, 9.0, 14.0};
const std::vector<double> restitutions{0.0, 0.31, 0.52, 0.66, 0.68, 0.61, 0.50};

}  // namespace

TEST_CASE("a measured curve passes through its points") {
    const MeasuredCurve curve(velocities, restitutions);
    CHECK(curve.lower() == 1.92);
    CHECK(curve.upper() == 14.0);
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        CHECK(std::abs(curve(velocities[i]) - restitutions[i]) < 1e-15);
    }
}

TEST_CASE("no value lies outside its two neighbours, and between them the curve is monotone") {
    Random random(5);
    for (int curve_number = 0; curve_number < 50; ++curve_number) {
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i < 8; ++i) {
            x.push_back((x.empty() ? 0.0 : x.back()) + random.log_uniform(1e-3, 10.0));
            y.push_back(random.uniform(0.0, 1.0));
        }
        const MeasuredCurve curve(x, y);
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            double before = y[i];
            const double lower = std::min(y[i], y[i + 1]) - 1e-15;
            const double upper = std::max(y[i], y[i + 1]) + 1e-15;
            const double direction = y[i + 1] - y[i];
            bool inside = true;
            bool monotone = true;
            for (int k = 1; k <= 40; ++k) {
                const double value = curve(std::min(x[i] + (x[i + 1] - x[i]) * k / 40.0, x[i + 1]));
                inside = inside && value >= lower && value <= upper;
                monotone = monotone && (value - before) * direction >= -1e-15;
                before = value;
            }
            CHECK(inside);
            CHECK(monotone);
        }
    }
}

TEST_CASE("a straight line stays straight, a step stays a step") {
    const std::vector<double> x{0.5, 1.0, 2.5, 4.0};
    const std::vector<double> line{1.0, 2.0, 5.0, 8.0};
    const MeasuredCurve straight(x, line);
    for (int i = 0; i < 10; ++i) {
        const double at = 0.5 + 0.37 * i;
        CHECK(relative_difference(straight(at), 2.0 * at) < 1e-14);
    }
    const std::vector<double> step{0.0, 0.0, 1.0, 1.0};
    const MeasuredCurve jump(x, step);
    CHECK(jump(0.7) == 0.0);
    CHECK(jump(3.3) == 1.0);
    CHECK(std::abs(jump(1.75) - 0.5) < 1e-15);
}

TEST_CASE("nothing is extrapolated") {
    const MeasuredCurve curve(velocities, restitutions);
    CHECK(input_error_of([&] { static_cast<void>(curve(1.9)); }) ==
          "a measured curve is asked for its value at 1.900000; allowed: 1.920000 to 14.000000, the measured "
          "range");
    CHECK_THROWS_AS(static_cast<void>(curve(14.1)), InputError);
    CHECK_THROWS_AS(static_cast<void>(curve(std::numeric_limits<double>::quiet_NaN())), InputError);
}

TEST_CASE("curves that are none are refused") {
    const auto message = [](std::vector<double> x, std::vector<double> y) {
        return input_error_of([&] { MeasuredCurve(x, y); });
    };
    CHECK(message({1, 2}, {1, 2}) ==
          "a measured curve has 2 abscissae and 2 values; allowed: as many of both, at least 3");
    CHECK(contains(message({1, 2, 3}, {1, 2}), "has 3 abscissae and 2 values"));
    CHECK(message({1, 3, 2}, {1, 2, 3}) ==
          "point 3 of a measured curve is out of order or not finite; allowed: finite values, abscissae "
          "strictly increasing");
    CHECK(contains(message({1, 1, 2}, {1, 2, 3}), "point 2 of a measured curve"));
    CHECK(contains(message({1, 2, 3}, {1, std::nan(""), 3}), "point 2 of a measured curve"));
    CHECK(contains(message({std::nan(""), 2, 3}, {1, 2, 3}), "point 1 of a measured curve"));
}

TEST_CASE("a curve can be moved") {
    MeasuredCurve first(velocities, restitutions);
    const double value = first(2.7);
    MeasuredCurve second(std::move(first));
    CHECK(second(2.7) == value);
    MeasuredCurve third(std::vector<double>{1, 2, 3}, std::vector<double>{1, 2, 3});
    third = std::move(second);
    CHECK(third(2.7) == value);
}
