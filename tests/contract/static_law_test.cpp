// SPDX-License-Identifier: GPL-3.0-or-later

// A law's own lines: polynomials, derivatives, signs, special points and units, for every registered law.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/contact/registry.hpp"
#include "solver/contact/static_branch.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/polynomial.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"

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

/// An impact by a law with any damping law and detachment, admissible or not, over the whole range that fly
/// ash and its neighbours span.
Impact random_impact(Law law, Random& random) {
    ContactCase c{.law = law,
                  .damping_law = all_values<DampingLaw>[random.below(all_values<DampingLaw>.size())],
                  .detachment = all_values<Detachment>[random.below(all_values<Detachment>.size())]};
    const ContactPair pair = random_pair(random);
    if (random.below(2) == 0) c.yield_pressure = pair.contact_modulus * random.log_uniform(1e-3, 1.0);
    const double velocity = random.log_uniform(1e-4, 1e3);
    return impact_of(c, pair, random.uniform(0.0, 2.0), velocity);
}

struct Tally {
    int rebounds = 0;
    int captures = 0;
    int refusals = 0;
    int beyond_theory = 0;   ///< overlap larger than the radius
    int beyond_closure = 0;  ///< flattened by adhesion alone, and refused
};

/// The result, or nothing where a contact yields beyond what its law can say.
std::optional<ImpactResult> solved_or_refused(const Impact& impact) {
    try {
        return solved(impact);
    } catch (const InputError& error) {
        if (error.problem().find("outside the range of the plastic closure") == std::string::npos) throw;
        return std::nullopt;
    }
}

/// What a number of impacts did.
struct Findings {
    Tally tally;
    Worst ledger;
    Worst in_double;
};

void check_impact(const Impact& impact, Findings& findings) {
    CAPTURE(describe(impact));
    if (refusal(impact.law, impact.detachment)) {
        CHECK_THROWS_AS(static_cast<void>(solve_impact(impact)), InputError);
        ++findings.tally.refusals;
        return;
    }
    const std::optional<ImpactResult> found = solved_or_refused(impact);
    if (!found) {
        ++findings.tally.beyond_closure;
        return;
    }
    const ImpactResult& result = *found;
    const bool rebound = result.outcome == Outcome::rebound;
    (rebound ? findings.tally.rebounds : findings.tally.captures) += 1;
    const EnergyLedger& energy = result.energy;
    const double size = std::max(energy.incident, std::abs(energy.minimum));
    findings.ledger.see(std::abs(energy.residual) / size, describe(impact));

    const bool consistent =
        std::isfinite(result.maximum_overlap) && result.maximum_overlap > 0.0 &&
        result.contact_time.has_value() == rebound &&
        (rebound ? result.restitution > 0.0 && result.restitution <= 1.0 : result.restitution == 0.0) &&
        result.rebound_velocity == result.restitution * impact.velocity && result.steps > 0 &&
        (!result.approach_time || *result.approach_time > 0.0) &&
        (!rebound || *result.contact_time > result.approach_time.value());
    CHECK(consistent);

    findings.tally.beyond_theory += result.maximum_overlap > impact.contact.effective_radius ? 1 : 0;
    const double conditioning = size / energy.incident / std::max(result.restitution, 1e-8);
    if (conditioning < 1e3)
        findings.in_double.see(std::abs(restitution_of(impact) - result.restitution), describe(impact));
}

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

// Ten thousand impacts of anything: each ends in a rebound, a capture or a typed refusal, and its ledger
// closes.

TEST_CASE("random impacts end in a rebound, a capture or a refusal, and their energy is accounted for") {
    Findings findings;
    const int times = repetitions(10'000);
    for (std::size_t i = 0; i < Law::count(); ++i) {
        Random random = random_of(Law::at(i).name(), 3);
        const int enough = times * (static_cast<int>(i) + 1) / static_cast<int>(Law::count());
        while (findings.tally.rebounds + findings.tally.captures < enough)
            check_impact(random_impact(Law::at(i), random), findings);
    }
    const auto& [tally, ledger, in_double] = findings;
    MESSAGE(tally.rebounds << " rebounds, " << tally.captures << " captures, " << tally.refusals
                           << " refusals; " << tally.beyond_theory
                           << " with an overlap beyond the radius, outside the theory");
    CHECK(tally.rebounds > times / 4);
    CHECK(tally.captures > times / 4);
    CHECK(tally.refusals > times / 10);
    CHECK(tally.beyond_theory > 0);
    CHECK(tally.beyond_closure < times / 100);
    CHECK_MESSAGE(ledger.deviation() < 1e-10, ledger.where());
    CHECK_MESSAGE(in_double.deviation() < 1e-10, in_double.where());
}
