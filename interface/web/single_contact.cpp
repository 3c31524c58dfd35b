// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/web/single_contact.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "interface/law_inputs.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

/// A number of the page in the form that options have; empty where it is missing or null.
std::string option(const Json& contact, std::string_view key) {
    const auto found = contact.find(key);
    if (found == contact.end() || found->is_null()) return {};
    return found->is_string() ? found->get<std::string>() : fmt::format("{}", found->get<double>());
}

/// The contact of the page as options: contact_modulus is --contact-modulus.
CommandOptions options_of(const Json& contact) {
    CommandOptions options;
    for (const auto& [key, value] : contact.items()) {
        if (!value.is_number() && !value.is_string()) continue;
        std::string name = "--" + key;
        std::ranges::replace(name, '_', '-');
        options.text_of(name) = option(contact, key);
    }
    return options;
}

/// Damping over increasing velocity [m/s]: linear between these, constant beyond them.
struct DampingCourse {
    std::vector<double> velocities;
    std::vector<double> dampings;
};

DampingCourse course_of(const Json& contact, double constant) {
    auto velocities = contact.at("velocities").get<std::vector<double>>();
    auto dampings = contact.contains("dampings") ? contact.at("dampings").get<std::vector<double>>()
                                                 : std::vector<double>(velocities.size(), constant);
    if (velocities.empty() || dampings.size() != velocities.size())
        throw InputError("dampings are not as many as velocities", "one for each, at least one");
    return {std::move(velocities), std::move(dampings)};
}

/// The critical velocity of impacts with a damping.
CriticalVelocity critical_velocity_with(double damping, const Impact& impact) {
    return critical_velocity({.law = impact.law,
                              .detachment = impact.detachment,
                              .damping = {impact.damping.law, damping},
                              .contact = impact.contact});
}

/// Where no damping is stated, its scaled coefficient is 1 at this velocity [m/s].
constexpr double guess_velocity = 1;

/// Where restitution leaves zero on a course: the velocity that is the critical one of the damping there.
CriticalVelocity critical_velocity_on(const DampingCourse& course, const std::vector<double>& restitution,
                                      const Impact& impact) {
    const auto first = std::find_if(restitution.begin(), restitution.end(), [](double e) { return e > 0; });
    if (first == restitution.end()) return critical_velocity_with(course.dampings.back(), impact);
    if (first == restitution.begin()) return critical_velocity_with(course.dampings.front(), impact);
    const auto after = static_cast<std::size_t>(first - restitution.begin());
    double captured = 0;  // shares of the way between the two velocities
    double rebounding = 1;
    const auto between = [&](const std::vector<double>& values, double share) {
        return values[after - 1] + share * (values[after] - values[after - 1]);
    };
    constexpr double enough = 1e-9;
    while (rebounding - captured > enough) {
        const double middle = (captured + rebounding) / 2;
        const auto critical = critical_velocity_with(between(course.dampings, middle), impact).value;
        (critical && between(course.velocities, middle) > *critical ? rebounding : captured) = middle;
    }
    CriticalVelocity found;
    found.value = between(course.velocities, rebounding);
    return found;
}

}  // namespace

Json single_impact_json(const Json& contact) {
    const CommandOptions options = options_of(contact);
    const ContactChoice choice = read_contact(options);
    const Impact impact{.law = choice.law,
                        .detachment = choice.detachment,
                        .damping = read_damping(options),
                        .contact = choice.contact,
                        .velocity = contact.at("velocity").get<double>()};
    return impact_json(impact, solve_impact(impact));
}

Json laws_json() {
    const std::vector<Law> by_default = default_laws();
    Json laws = Json::object();
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        Json parameters = Json::array();
        for (const LawParameter& parameter : inputs_of(law))
            parameters.push_back({{"name", parameter.name},
                                  {"unit", si_unit(parameter.dimension)},
                                  {"description", parameter.description},
                                  {"example", parameter.example},
                                  {"choice", parameter.choice}});
        laws[law.name()] = {{"title", report::display_name(law.name())},
                            {"by_default", std::ranges::find(by_default, law) != by_default.end()},
                            {"parameters", parameters}};
    }
    Json dampings = Json::object();
    for (const DampingLaw law : all_values<DampingLaw>) dampings[name_of(law)] = {{"unit", unit_of(law)}};
    return {{"laws", laws}, {"damping_laws", dampings}};
}

Json curve_json(const Json& contact) {
    const CommandOptions options = options_of(contact);
    const ContactChoice choice = read_contact(options);
    Impact impact{.law = choice.law,
                  .detachment = choice.detachment,
                  .damping = read_damping(options),
                  .contact = choice.contact,
                  .velocity = 1};
    if (!contact.contains("damping"))
        impact.damping.coefficient =
            Scale::of(choice.contact, guess_velocity).damping_coefficient(impact.damping.law, 1);
    const DampingCourse course = course_of(contact, impact.damping.coefficient);
    const double damping = impact.damping.coefficient;
    std::vector<double> restitution;
    for (std::size_t i = 0; i < course.velocities.size(); ++i) {
        impact.velocity = course.velocities[i];
        impact.damping.coefficient = course.dampings[i];
        validate(impact);
        restitution.push_back(restitution_of(impact));
    }
    const CriticalVelocity critical = critical_velocity_on(course, restitution, impact);
    return {{"restitution", restitution},
            {"critical_velocity", critical.value ? Json(*critical.value) : Json(nullptr)},
            {"damping", damping},
            {"always_captured", critical.verdict == CaptureVerdict::always_captured}};
}

}  // namespace ashimpact
