// SPDX-License-Identifier: GPL-3.0-or-later

// Every registered law and damping law: a contact with E*/S has the restitutions and the critical velocities
// of the stiff one, if all its constants follow.
#include "solver/dem/softening.hpp"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include <doctest/doctest.h>

#include "solver/contact/law_parameters.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double factors[] = {10.0, 1000.0, 10000.0};

Impact softened(const Impact& stiff, double factor) {
    Impact soft = stiff;
    soft.contact = ashimpact::softened(stiff.contact, factor);
    soft.damping = ashimpact::softened(stiff.damping, stiff.contact, factor);
    return soft;
}

/// The impact with one parameter of a choice given instead of another.
Impact with_parameter(Impact impact, const LawParameter& given) {
    ParameterValues<double> values;
    for (const LawParameter& parameter : law_parameters()) {
        const bool alternative = given.choice != 0 && parameter.choice == given.choice;
        if (!alternative && impact.contact.parameters.has(parameter))
            values.set(parameter.name, impact.contact.parameters[parameter]);
    }
    values.set(given.name, given.typical);
    impact.contact.parameters = values;
    return impact;
}

}  // namespace

TEST_CASE("a softened contact has the restitution of the stiff one, and its times and overlaps stretched") {
    Worst restitution;
    Worst stretch;
    std::size_t turn = 0;
    for (const ContactCase& c : contact_cases())
        for (const double w : ash_adhesions)
            for (const double v : ash_velocities)
                for (const double number : damping_numbers) {
                    const double factor = factors[turn++ % std::size(factors)];
                    const Impact stiff = impact_of(c, ash(w), number, v);
                    const ImpactResult a = solved(stiff);
                    const ImpactResult b = solved(softened(stiff, factor));
                    const std::string where = describe(stiff) + ", S = " + std::to_string(factor);
                    const auto see = [&](double before, double after) {
                        stretch.see(relative_difference(before * stretch_of(factor), after), where);
                    };
                    CHECK(a.outcome == b.outcome);
                    CHECK(a.contact_time.has_value() == b.contact_time.has_value());
                    restitution.see(relative_difference(a.restitution, b.restitution), where);
                    see(a.maximum_overlap, b.maximum_overlap);
                    if (a.contact_time && b.contact_time) see(*a.contact_time, *b.contact_time);
                }
    CHECK(restitution.count() > 1000);
    CHECK_MESSAGE(restitution.deviation() < 1e-12, restitution.where());
    CHECK_MESSAGE(stretch.deviation() < 1e-12, stretch.where());
}

TEST_CASE("a softened contact has the critical velocity of the stiff one") {
    Worst worst;
    for (const ContactCase& c : contact_cases())
        for (const double number : damping_numbers) {
            const Impact stiff = impact_of(c, ash(0.3), number, 2.0);
            const CriticalVelocity hard = critical_of(stiff);
            for (const double factor : factors) {
                const CriticalVelocity soft = critical_of(softened(stiff, factor));
                CHECK(soft.verdict == hard.verdict);
                if (hard.value && soft.value)
                    worst.see(relative_difference(*soft.value, *hard.value), describe(stiff));
            }
        }
    CHECK(worst.count() > 100);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("every parameter of a law goes with a power of the overlap, and no other keeps the restitution") {
    int moved = 0;
    for (std::size_t i = 0; i < Law::count(); ++i)
        for (const DampingLaw damping_law : all_values<DampingLaw>)
            for (const LawParameter& parameter : parameters_of(Law::at(i), damping_law)) {
                CAPTURE(parameter.name);
                const ContactCase c{Law::at(i), damping_law, Law::at(i).default_detachment()};
                const Impact stiff = with_parameter(impact_of(c, ash(0.3), 0.05, 0.5), parameter);
                Impact soft = softened(stiff, 1000.0);
                const double e = solved(stiff).restitution;
                CHECK(relative_difference(solved(soft).restitution, e) < 1e-12);
                if (length_power(parameter) == 0.0) continue;
                ++moved;
                const double kept = stiff.contact.parameters[parameter];
                soft.contact.parameters.set(parameter.name, kept);
                const ImpactResult other = solve_impact(soft);
                CHECK(relative_difference(other.restitution, e) > 1e-6);
            }
    CHECK(moved >= 3);
}

TEST_CASE("the scaled coefficient of a damping law stays the same in a softened contact") {
    for (const DampingLaw law : all_values<DampingLaw>) {
        CAPTURE(name_of(law));
        const ContactPair stiff = ash(0.3);
        const Damping damping{law, Scale::of(stiff, 2.0).damping_coefficient(law, 0.3)};
        const ContactPair soft = ashimpact::softened(stiff, 1000.0);
        const double number =
            Scale::of(soft, 2.0).damping_number(ashimpact::softened(damping, stiff, 1000.0));
        CHECK(relative_difference(number, 0.3) < 1e-14);
        // The unit of the law and the dimension of its coefficient state the same power.
        const double power = std::log(softening_of(law, stiff, 1000.0)) / std::log(stretch_of(1000.0));
        CHECK(length_power(dimension_of(law)).value() == doctest::Approx(power).epsilon(1e-12));
    }
}
