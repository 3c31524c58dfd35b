// SPDX-License-Identifier: GPL-3.0-or-later
// The static JKR law against Dong et al. 2013, Eqs. 15-20 (SI) and 25-27 (normalised), written from the paper
// as corrected in docs/errata.md.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "solver/contact/static_curve.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/quadrature.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double pi = std::numbers::pi;

/// Eqs. 25-27 at a normalised contact radius.
struct Published {
    double overlap;
    double repulsive;
    double attractive;
    double total;
};

Published published(double a) {
    Published p{};
    p.overlap = a * a - 2.0 * std::sqrt(2.0 * a / 3.0);
    p.total = std::pow(a, 3.0) - std::sqrt(6.0) * std::pow(a, 1.5);
    if (a > std::cbrt(2.0 / 3.0)) {
        p.attractive = -2.0 * std::pow(2.0 * a / 3.0, 0.75);
        p.repulsive = p.total + 2.0 * std::pow(2.0 * a / 3.0, 0.75);
    } else {
        p.attractive = p.total;
    }
    return p;
}

/// Normalised constants of Eq. 21 for a pair.
struct Units {
    double radius;
    double overlap;
    double force;
};

Units units_of(const ContactPair& pair) {
    const double w = pair.work_of_adhesion;
    const double r = pair.effective_radius;
    const double e = pair.contact_modulus;
    const double k = 4.0 / 3.0 * e;
    return {std::cbrt(pi * w * r * r / k), std::cbrt(9.0 * pi * pi * w * w * r / (16.0 * e * e)), pi * w * r};
}

const StaticCurve& normalised() {
    static const StaticCurve curve = StaticCurve::normalised(Law::of<Jkr>());
    return curve;
}

}  // namespace

TEST_CASE("normalised: Eqs. 25-27 on both ranges of contact radius") {
    Worst worst;
    for (int i = 0; i < 345; ++i) {
        const double a = std::pow(6.0, -1.0 / 3.0) * (1.0 + 1e-12) + 0.01 * i;
        const StaticPoint point = normalised().at_contact_radius(a);
        const Published p = published(a);
        const double size = a * a * a + std::sqrt(6.0) * std::pow(a, 1.5);
        const std::string where = std::to_string(a);
        worst.see(std::abs(point.overlap - p.overlap) / (a * a + 1.0), where);
        worst.see(std::abs(point.repulsive_force - p.repulsive) / size, where);
        worst.see(std::abs(point.attractive_force - p.attractive) / size, where);
        worst.see(std::abs(point.force() - p.total) / size, where);
    }
    CHECK(worst.count() > 1000);
    CHECK_MESSAGE(worst.deviation() < 1e-14, worst.where());
}

TEST_CASE("SI at fly-ash scale: the normalised curve times the units of Eq. 21") {
    Worst worst;
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const Units unit = units_of(pair);
        const StaticCurve curve(Law::of<Jkr>(), pair);
        for (const double a : {0.56, 0.8, 1.0, 1.3, 2.0, 5.0}) {
            const StaticPoint point = curve.at_contact_radius(a * unit.radius);
            const Published p = published(a);
            const std::string where = std::to_string(w) + " " + std::to_string(a);
            worst.see(relative_difference(point.overlap, p.overlap * unit.overlap), where);
            worst.see(relative_difference(point.attractive_force, p.attractive * unit.force), where);
            worst.see(std::abs(point.repulsive_force / unit.force - p.repulsive) / (1 + p.repulsive), where);
            worst.see(std::abs(point.force() / unit.force - p.total) / (1 + std::abs(p.total)), where);
        }
    }
    CHECK_MESSAGE(worst.deviation() < 1e-13, worst.where());
}

TEST_CASE(
    "SI at fly-ash scale: contact radius of a force (Eq. 15), pressures and their integrals (Eqs. 16-20)") {
    Worst worst;
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const double r = pair.effective_radius;
        const double k = 4.0 / 3.0 * pair.contact_modulus;
        const StaticCurve curve(Law::of<Jkr>(), pair);
        for (const double ratio : {1.2, 1.5, 2.5, 6.0}) {
            const double a = ratio * units_of(pair).radius;
            const StaticPoint point = curve.at_contact_radius(a);
            const double f = point.force();
            const double three = 3.0 * pi * w * r;
            const std::string where = std::to_string(w) + " " + std::to_string(ratio);
            const double cube = r / k * (f + three + std::sqrt(2.0 * three * f + three * three));  // Eq. 15
            worst.see(relative_difference(std::cbrt(cube), a), where);
            const double overlap = (a * a - std::sqrt(8.0 * pi * w * r * r / (3.0 * k) * a)) / r;  // Eq. 16
            worst.see(relative_difference(point.overlap, overlap), where);
            const double p0 = 3.0 * a * k / (2.0 * pi * r);
            const double q0 = std::sqrt(3.0 * w * k / (2.0 * pi * a)) / p0;
            const double area = pi * a * a * p0;
            worst.see(relative_difference(point.attractive_force, -4.0 / 3.0 * std::pow(q0, 1.5) * area),
                      where);
            worst.see(std::abs(f - (2.0 / 3.0 - 2.0 * q0) * area) / area, where);  // Eq. 19
            const double repulsive = (2.0 / 3.0 - 2.0 * q0 + 4.0 / 3.0 * std::pow(q0, 1.5)) * area;
            worst.see(std::abs(point.repulsive_force - repulsive) / area, where);  // Eq. 20
        }
    }
    CHECK_MESSAGE(worst.deviation() < 1e-13, worst.where());
}

TEST_CASE("pull-off: the largest tension is (3/2) pi w R at abar = (3/2)^(1/3)") {
    const double least = normalised().at_contact_radius(std::cbrt(1.5)).force();
    CHECK(relative_difference(least, -1.5) < 1e-15);
    for (const double a : {0.9, 0.999, 1.001, 1.1}) {
        CHECK(normalised().at_contact_radius(a * std::cbrt(1.5)).force() > least);
    }
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const double tension = StaticCurve(Law::of<Jkr>(), pair)
                                   .at_contact_radius(std::cbrt(1.5) * units_of(pair).radius)
                                   .force();
        CHECK(relative_difference(tension, -1.5 * pi * w * 44e-6) < 1e-14);
        CHECK(relative_difference(tension, -jkr_pull_off_force(pair)) < 1e-14);
    }
}

TEST_CASE("the fold: abar = 6^(-1/3), deltabar = -3 6^(-2/3), (5/9) of the pull-off force") {
    const StaticPoint fold = normalised().first();
    CHECK(relative_difference(fold.contact_radius, std::pow(6.0, -1.0 / 3.0)) < 1e-15);
    CHECK(relative_difference(fold.overlap, -3.0 * std::pow(6.0, -2.0 / 3.0)) < 1e-15);
    CHECK(relative_difference(fold.force(), -5.0 / 9.0 * 1.5) < 1e-15);
    CHECK(fold.repulsive_force == 0.0);
    // No static contact is more stretched.
    CHECK(normalised().at_contact_radius(1.01 * fold.contact_radius).overlap > fold.overlap);
    CHECK(published(0.99 * fold.contact_radius).overlap > fold.overlap);
}

TEST_CASE("first touch: abar = (8/3)^(1/3) at zero overlap, (8/9) of the pull-off force") {
    const StaticPoint touch = normalised().at_overlap(0.0);
    CHECK(relative_difference(touch.contact_radius, std::cbrt(8.0 / 3.0)) < 1e-15);
    CHECK(relative_difference(touch.force(), -8.0 / 9.0 * 1.5) < 1e-14);
}

TEST_CASE("the work from first touch to the end is 7.092196, at the largest tension 3.502602") {
    // In SI, by quadrature of the force over the overlap in a variable that is smooth at the fold.
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const StaticCurve curve(Law::of<Jkr>(), pair);
        const double unit = std::cbrt(std::pow(w, 5) * std::pow(44e-6, 4) / (90e9 * 90e9));
        const auto work_to = [&](double end) {
            return integral(
                [&](double x) { return curve.at_overlap(end * (1 - x * x)).force() * 2 * x * end; }, 0.0,
                1.0);
        };
        CAPTURE(w);
        CHECK(relative_difference(work_to(curve.first().overlap) / unit, 7.0921959718639584) < 1e-12);
        const double tension_overlap = published(std::cbrt(1.5)).overlap * units_of(pair).overlap;
        CHECK(relative_difference(work_to(tension_overlap) / unit, 3.5026019718352908) < 1e-12);
    }
}
