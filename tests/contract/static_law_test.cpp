// SPDX-License-Identifier: GPL-3.0-or-later
// A law's own lines: polynomials, derivatives, signs, special points and units, for every registered law.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/registry.hpp"
#include "solver/contact/static_branch.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/polynomial.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

using Real = long double;
using RealPolynomial = Polynomial<Real>;

/// Every law whose lines are polynomials; that of Maugis has tests of its own.
template <class Visitor>
void for_each_law(Visitor&& visitor) {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        Law::at(i).visit<void>([&]<template <class> class L>() {
            if constexpr (has_polynomials<L>) visitor.template operator()<L>();
        });
    }
}

/// How many those are.
int laws_with_polynomials() {
    int count = 0;
    for_each_law([&]<template <class> class L>() { ++count; });
    return count;
}

/// Adhesion numbers of a law at fly-ash scale.
template <template <class> class L>
std::vector<Real> adhesion_numbers() {
    std::vector<Real> numbers;
    for (const double w : ash_adhesions) {
        for (const double v : ash_velocities) {
            numbers.push_back(L<double>::adhesion_number(ash(w), Scale::of(ash(w), v).length));
        }
    }
    return numbers;
}

/// Overlap and force of a law as the motion has them, near a state u.
struct StaticPolynomials {
    RealPolynomial overlap;
    RealPolynomial force;
    bool holds;  ///< a per cent to either side of u too
};
template <template <class> class L>
StaticPolynomials polynomials(Real adhesion, Real u) {
    const auto pieces = static_branches<L>(adhesion);
    const auto holds = [](Real x) {
        return [x](const StaticBranch<Real>& piece) { return x <= piece.until; };
    };
    const auto piece = std::ranges::find_if(pieces, holds(u));
    return {piece->overlap, piece->forces.repulsion - piece->forces.attraction,
            piece == std::ranges::find_if(pieces, holds(0.99L * u)) &&
                piece == std::ranges::find_if(pieces, holds(1.01L * u))};
}

/// Sum of the magnitudes of a polynomial's terms: what its value at @p x is exact relative to.
Real magnitude(const RealPolynomial& p, Real x) {
    Real sum = 0;
    for (int i = 0; i <= p.degree; ++i) sum += std::abs(p[i]) * std::pow(std::abs(x), static_cast<Real>(i));
    return sum;
}

/// Derivative by central differences, extrapolated to seventh order in the step.
template <class Function>
Real finite_difference(Function&& function, Real x) {
    std::vector<Real> column;
    Real h = x / 250;
    for (int i = 0; i < 4; ++i, h /= 2) column.push_back((function(x + h) - function(x - h)) / (2 * h));
    for (Real factor = 4; column.size() > 1; factor *= 4) {
        for (std::size_t i = 0; i + 1 < column.size(); ++i) {
            column[i] = (factor * column[i + 1] - column[i]) / (factor - 1);
        }
        column.pop_back();
    }
    return column.front();
}

/// "dmt: 0.4". Appending keeps GCC 12 from a false warning about operator+.
std::string place(std::string_view law, std::string_view detail) {
    std::string text(law);
    text += ": ";
    text += detail;
    return text;
}

constexpr Real states[] = {0.05L, 0.2L, 0.4L, 0.7L, 0.9L, 1.1L, 1.4L, 2.0L};

}  // namespace

TEST_CASE("overlap and force are the polynomials that the motion is built from, and so are their slopes") {
    Worst value;
    Worst slope;
    for_each_law([&]<template <class> class L>() {
        for (const Real adhesion : adhesion_numbers<L>()) {
            const L<Real> law{adhesion};
            for (const Real u : states) {
                const auto [overlap, force, holds] = polynomials<L>(adhesion, u);
                if (!holds) continue;
                const std::string where = place(law.name, std::to_string(u));
                const auto see = [&](const RealPolynomial& p, auto&& function) {
                    const RealPolynomial derivative = p.derivative();
                    const Real size = magnitude(p, u);
                    value.see(static_cast<double>(std::abs(p(u) - function(u)) / size), where);
                    slope.see(static_cast<double>(std::abs(derivative(u) - finite_difference(function, u)) /
                                                  (magnitude(derivative, u) + size / u)),
                              where);
                };
                see(overlap, [&](Real x) { return law.overlap(x); });
                see(force, [&](Real x) { return law.force(x); });
            }
        }
    });
    CHECK(value.count() >= laws_with_polynomials() * 100);
    CHECK_MESSAGE(value.deviation() < 1e-18, value.where());
    CHECK_MESSAGE(slope.deviation() < 1e-14, slope.where());
}

TEST_CASE("what a law states of itself fits its force and pressure") {
    const double overlap = 1e-7;
    const auto attraction = [&](Law law, const ContactPair& pair) {
        return StaticCurve(law, pair).at_overlap(overlap).attractive_force;
    };
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        CAPTURE(law.name());
        CHECK(std::filesystem::exists(std::filesystem::path(ASHIMPACT_TEST_DATA) / "../.." / law.page()));
        ContactPair pair = ash(0.3);
        const double radius = StaticCurve(law, pair).at_overlap(overlap).contact_radius;
        CHECK((attraction(law, pair) != 0.0) == law.is_adhesive());
        CHECK(law.pressure(pair, radius).central() > 0.0);
        CHECK(law.pressure(ash(0.0), radius).central() == hertz_pressure(pair, radius).central());
        const double before = attraction(law, pair);
        pair.work_of_adhesion = 0.6;
        CHECK((attraction(law, pair) != before) == law.uses_work_of_adhesion());
        CHECK((law.trust(1.0, false) == Trust::leaves_adhesion_out) == !law.is_adhesive());
        CHECK((law.trust(1.0, true) == Trust::describes_yield) == law.is_plastic());
        CHECK(law.similar().self_similar());
    }
}

TEST_CASE("a law that is a limit of the Tabor parameter is trusted on its side of it") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        if (law.limit() == AdhesionRegime::none) continue;
        CAPTURE(law.name());
        const bool soft = law.limit() == AdhesionRegime::jkr;
        CHECK(law.trust(soft ? 10.0 : 0.01, false) < law.trust(soft ? 0.01 : 10.0, false));
    }
}

TEST_CASE("first touch is at zero overlap, and the special points are what their names say") {
    Worst worst;
    for_each_law([&]<template <class> class L>() {
        for (const Real adhesion : adhesion_numbers<L>()) {
            const L<Real> law{adhesion};
            const auto root_of = [&](const RealPolynomial& p, Real u, std::string_view point) {
                const Real size = magnitude(p, u);
                worst.see(size == 0 ? 0.0 : static_cast<double>(std::abs(p(u)) / size),
                          place(law.name, point));
            };
            root_of(polynomials<L>(adhesion, law.touch()).overlap, law.touch(), "touch");
            for (const Detachment detachment : all_values<Detachment>) {
                const auto point = law.detachment_point(detachment);
                if (!point) continue;
                const auto [overlap, force, holds] = polynomials<L>(adhesion, *point);
                switch (detachment) {
                    case Detachment::zero_overlap:
                        root_of(overlap, *point, name_of(detachment));
                        break;
                    case Detachment::zero_force:
                        root_of(force, *point, name_of(detachment));
                        break;
                    case Detachment::pull_off:
                        root_of(overlap.derivative(), *point, name_of(detachment));
                        break;
                    case Detachment::load_controlled:
                        root_of(force.derivative(), *point, name_of(detachment));
                        CHECK(force(*point) < 0);
                        CHECK(force(*point) < std::min(force(*point * 0.99L), force(*point * 1.01L)));
                        break;
                }
            }
        }
    });
    CHECK(worst.count() >= laws_with_polynomials() * 18);
    CHECK_MESSAGE(worst.deviation() < 1e-17, worst.where());
}

TEST_CASE("attraction never pushes, repulsion never pulls, and both add up to the force") {
    for_each_law([&]<template <class> class L>() {
        for (const Real adhesion : adhesion_numbers<L>()) {
            const L<Real> law{adhesion};
            const Real first = *law.detachment_point(law.default_detachment);
            for (const Real u : states) {
                const Real attraction = attractive_force(law, Real(first + u));
                const Real repulsion = law.force(first + u) - attraction;
                CAPTURE(law.name);
                CAPTURE(u);
                CHECK(attraction <= 0);
                CHECK(repulsion >= 0);
            }
            const L<Real> bare{0};
            CHECK(attractive_force(bare, 1.1L) == 0);
        }
    });
}

TEST_CASE("the adhesion number carries the law's units: SI forces do not depend on the unit of length") {
    Worst worst;
    for_each_law([&]<template <class> class L>() {
        for (const double w : ash_adhesions) {
            const ContactPair pair = ash(w);
            const auto si = [&](double length, double contact_radius) {
                const L<double> law{L<double>::adhesion_number(pair, length)};
                const double u = std::sqrt(contact_radius / std::sqrt(pair.effective_radius * length));
                return std::pair{law.overlap(u) * length,
                                 law.force(u) * hertz_stiffness(pair) * std::pow(length, 1.5)};
            };
            for (const double a : {0.4e-6, 1e-6, 3e-6}) {
                const auto [overlap, force] = si(1e-7, a);
                const auto [same_overlap, same_force] = si(7.3e-7, a);
                worst.see(relative_difference(overlap, same_overlap), std::string(L<double>::name));
                worst.see(relative_difference(force, same_force), std::string(L<double>::name));
            }
        }
    });
    CHECK_MESSAGE(worst.deviation() < 1e-13, worst.where());
}
