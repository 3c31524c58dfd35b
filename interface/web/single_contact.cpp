#include "interface/web/single_contact.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "pipeline/commands/contact_options.hpp"
#include "pipeline/commands/impact.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

namespace {

/// A number of the page in the form that options have; empty where it is missing or null.
std::string option(const Json& contact, std::string_view key) {
    const auto found = contact.find(key);
    if (found == contact.end() || found->is_null()) return {};
    return found->is_string() ? found->get<std::string>() : fmt::format("{}", found->get<double>());
}

ContactOptions options_of(const Json& contact) {
    ContactOptions options;
    constexpr std::array members{
        std::pair{"law", &ContactOptions::law},
        std::pair{"detachment", &ContactOptions::detachment},
        std::pair{"diameter", &ContactOptions::diameter},
        std::pair{"radius", &ContactOptions::radius},
        std::pair{"mass", &ContactOptions::mass},
        std::pair{"density", &ContactOptions::density},
        std::pair{"contact_modulus", &ContactOptions::contact_modulus},
        std::pair{"work_of_adhesion", &ContactOptions::work_of_adhesion},
        std::pair{"yield_pressure", &ContactOptions::yield_pressure},
        std::pair{"damping", &ContactOptions::damping},
    };
    for (const auto& [key, member] : members) options.*member = option(contact, key);
    if (contact.contains("damping_law")) options.damping_law = option(contact, "damping_law");
    for (std::size_t i = 0; i < law_parameters().size(); ++i)
        options.parameters[i] = option(contact, law_parameters()[i].name);
    return options;
}

}  // namespace

Json single_impact_json(const Json& contact) {
    const ContactOptions options = options_of(contact);
    const ContactChoice choice = read_contact(options);
    const Impact impact{.law = choice.law,
                        .detachment = choice.detachment,
                        .damping = read_damping(options),
                        .contact = choice.contact,
                        .velocity = contact.at("velocity").get<double>()};
    return impact_json(impact, solve_impact(impact));
}

Json curve_json(const Json& contact) {
    const ContactOptions options = options_of(contact);
    const ContactChoice choice = read_contact(options);
    Impact impact{.law = choice.law,
                  .detachment = choice.detachment,
                  .damping = read_damping(options),
                  .contact = choice.contact,
                  .velocity = 1};
    const CriticalVelocity critical = critical_velocity({.law = impact.law,
                                                         .detachment = impact.detachment,
                                                         .damping = impact.damping,
                                                         .contact = impact.contact});
    const Json& velocities = contact.at("velocities");
    Json restitution = Json::array();
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        impact.velocity = velocities[i].get<double>();
        if (contact.contains("dampings"))
            impact.damping.coefficient = contact.at("dampings").at(i).get<double>();
        validate(impact);
        restitution.push_back(restitution_of(impact));
    }
    return {{"restitution", restitution},
            {"critical_velocity", critical.value ? Json(*critical.value) : Json(nullptr)},
            {"always_captured", critical.verdict == CaptureVerdict::always_captured}};
}

}  // namespace ashimpact
