// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 3 of Dong et al. 2013: the normalised curves of Eqs. 22-24, written from the paper, and what the
// text reads off the figure.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/contact/static_curve.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// F_a of Eqs. 22-24 at a normalised overlap; F_r is overlap^(3/2) for all three.
double published_attraction(Law law, double overlap) {
    if (law == Law::of<Dmt>()) return -2.0;
    if (law == Law::of<BrachDunn>()) return -std::pow(6.0, 2.0 / 3.0) * std::sqrt(overlap);
    return 0.0;
}

}  // namespace

TEST_CASE("Hertz, DMT and Brach-Dunn: Eqs. 22-24") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        const StaticCurve curve = StaticCurve::normalised(law);
        CAPTURE(law.name());
        CHECK(curve.first().overlap == 0.0);
        for (int i = 0; i < 36; ++i) {
            const double overlap = 0.01 * std::pow(1.2, i);
            CAPTURE(overlap);
            const StaticPoint point = curve.at_overlap(overlap);
            const double repulsion = std::pow(overlap, 1.5);
            const double attraction = published_attraction(law, overlap);
            CHECK(relative_difference(point.overlap, overlap) < 1e-14);
            CHECK(relative_difference(point.contact_radius, std::sqrt(overlap)) < 1e-14);  // Eq. 5
            CHECK(std::abs(point.repulsive_force - repulsion) < 1e-14 * (repulsion - attraction));
            CHECK(relative_difference(point.attractive_force, attraction) < 1e-14);
        }
    }
}

TEST_CASE("Hertz, DMT and Brach-Dunn in SI at fly-ash scale: Eqs. 9-14") {
    for (const double w : ash_adhesions) {
        const double r = 44e-6;
        const double e = 90e9;
        const double pi = std::acos(-1.0);
        const double line = std::cbrt(6.0 * w * w * r * e / pi);  // Eq. 14
        for (const double overlap : {2e-9, 3e-8, 4e-7}) {
            const double hertz = 4.0 / 3.0 * e * std::sqrt(r) * std::pow(overlap, 1.5);
            const auto point = [&](Law law) { return StaticCurve(law, ash(w)).at_overlap(overlap); };
            CAPTURE(w);
            CAPTURE(overlap);
            CHECK(relative_difference(point(Law::of<Hertz>()).force(), hertz) < 1e-14);
            CHECK(relative_difference(point(Law::of<Dmt>()).attractive_force, -2.0 * pi * w * r) < 1e-14);
            CHECK(relative_difference(point(Law::of<BrachDunn>()).attractive_force,
                                      -2.0 * pi * line * std::sqrt(r * overlap)) < 1e-14);
            for (const Law law : {Law::of<Dmt>(), Law::of<BrachDunn>()}) {
                CHECK(std::abs(point(law).repulsive_force - hertz) <
                      1e-14 * (hertz - point(law).attractive_force));
            }
        }
    }
}

TEST_CASE(
    "the figure's table: evenly spaced in contact radius, from the start of the curve to the overlap asked "
    "for") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        if (!Law::at(i).parameters().empty()) {  // Eq. 21 has no unit for them
            CHECK_THROWS_AS(static_cast<void>(StaticCurve::normalised(Law::at(i))), InputError);
            continue;
        }
        const StaticCurve curve = StaticCurve::normalised(Law::at(i));
        const std::vector<StaticPoint> table = curve.sampled(3.0, 61);
        CAPTURE(Law::at(i).name());
        REQUIRE(table.size() == 61);
        CHECK(table.front().overlap == doctest::Approx(curve.first().overlap).epsilon(1e-14));
        CHECK(relative_difference(table.back().overlap, 3.0) < 1e-14);
        const double spacing = (table.back().contact_radius - table.front().contact_radius) / 60.0;
        for (std::size_t j = 1; j < table.size(); ++j) {
            CHECK(table[j].overlap > table[j - 1].overlap);
            CHECK(std::abs(table[j].contact_radius - table[j - 1].contact_radius - spacing) < 1e-14);
        }
    }
}

TEST_CASE("Brach-Dunn attracts two to three times as much as JKR, as the text says of the figure") {
    const auto ratio = [](double overlap) {
        const auto attraction = [&](Law law) {
            return StaticCurve::normalised(law).at_overlap(overlap).attractive_force;
        };
        return attraction(Law::of<BrachDunn>()) / attraction(Law::of<Jkr>());
    };
    CHECK(ratio(1.0) > 1.0);
    CHECK(ratio(3.0) > ratio(1.0));
    CHECK(ratio(3.0) > 1.5);
    CHECK(ratio(3.0) < 3.0);
}
