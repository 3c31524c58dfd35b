// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/contact_cases.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact::test {

namespace {

void add_detachments(Law law, DampingLaw damping_law, std::vector<ContactCase>& cases) {
    for (const Detachment detachment : all_values<Detachment>) {
        if (!refusal(law, detachment)) cases.push_back({law, damping_law, detachment});
    }
}

}  // namespace

std::vector<ContactCase> elastic_cases() {
    std::vector<ContactCase> cases;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        for (const DampingLaw damping : all_values<DampingLaw>) add_detachments(Law::at(i), damping, cases);
    }
    return cases;
}

std::vector<ContactCase> yielding_cases() {
    std::vector<ContactCase> cases = elastic_cases();
    for (ContactCase& c : cases) c.yield_pressure = 2e9;  // V_y = 0.7 m/s without adhesion
    std::erase_if(cases, [](const ContactCase& c) {
        ContactPair pair = ash(0.3);
        pair.yield_pressure = c.yield_pressure;
        return !can_yield(c.law, pair);
    });
    return cases;
}

std::vector<ContactCase> contact_cases() {
    std::vector<ContactCase> cases = elastic_cases();
    const std::vector<ContactCase> yielding = yielding_cases();
    cases.insert(cases.end(), yielding.begin(), yielding.end());
    return cases;
}

std::vector<ContactCase> undamped_cases() {
    std::vector<ContactCase> cases;
    for (std::size_t i = 0; i < Law::count(); ++i) add_detachments(Law::at(i), DampingLaw::constant, cases);
    return cases;
}

std::string name_of(const ContactCase& c) {
    return std::string(c.law.name()) + ", " + std::string(name_of(c.damping_law)) + ", " +
           std::string(name_of(c.detachment)) + (std::isfinite(c.yield_pressure) ? ", yielding" : "");
}

ParameterValues<double> parameters_like(double work_of_adhesion) {
    ParameterValues<double> values;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const double factor = Law::at(i).uses_work_of_adhesion() ? 1.0 : work_of_adhesion / 0.3;
        for (const auto& [name, value] : typical_parameters(Law::at(i))) values.set(name, factor * value);
    }
    for (const DampingLaw law : all_values<DampingLaw>)
        for (const auto& [name, value] : typical_parameters(parameters_of(law))) values.set(name, value);
    return values;
}

ContactPair ash(double work_of_adhesion) {
    constexpr double radius = 44e-6;
    return {.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * 2600.0,
            .effective_radius = radius,
            .contact_modulus = 90e9,
            .work_of_adhesion = work_of_adhesion,
            .parameters = parameters_like(work_of_adhesion)};
}

ContactPair random_pair(Random& random) {
    const double radius = random.log_uniform(1e-7, 1e-3);
    ContactPair pair{.mass = sphere_mass(radius, random.log_uniform(500.0, 2e4)),
                     .effective_radius = radius,
                     .contact_modulus = random.log_uniform(1e8, 1e12),
                     .work_of_adhesion = random.log_uniform(1e-4, 10.0)};
    pair.parameters = parameters_like(pair.work_of_adhesion);
    return pair;
}

Impact impact_of(const ContactCase& c, const ContactPair& pair, double damping_number, double velocity) {
    const Scale scale = Scale::of(pair, velocity);
    ContactPair contact = pair;
    contact.yield_pressure = c.yield_pressure;
    return {.law = c.law,
            .detachment = c.detachment,
            .damping = {c.damping_law, scale.damping_coefficient(c.damping_law, damping_number)},
            .contact = contact,
            .velocity = velocity};
}

ImpactResult solved(const Impact& impact) {
    INFO(describe(impact));
    return solve_impact(impact);
}

CriticalVelocity critical_of(const Impact& impact) {
    INFO(describe(impact));
    return critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
}

std::string describe(const Impact& impact) {
    std::ostringstream text;
    text.precision(17);
    text << name_of(
                ContactCase{impact.law, impact.damping.law, impact.detachment, impact.contact.yield_pressure})
         << ": m = " << impact.contact.mass << ", R = " << impact.contact.effective_radius
         << ", E* = " << impact.contact.contact_modulus << ", w = " << impact.contact.work_of_adhesion
         << ", p_y = " << impact.contact.yield_pressure << ", C = " << impact.damping.coefficient
         << ", v = " << impact.velocity;
    for (const auto& [name, value] : impact.contact.parameters) text << ", " << name << " = " << value;
    return text.str();
}

}  // namespace ashimpact::test
