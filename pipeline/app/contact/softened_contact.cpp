// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/contact/softened_contact.hpp"

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/layout.hpp"
#include "solver/dem/softening.hpp"

namespace ashimpact {

std::optional<SoftenedContact> read_softening(const CommandOptions& options, const ContactPair& pair,
                                              const std::optional<Damping>& damping) {
    if (!options.has("--soften")) return std::nullopt;
    const double factor = options.number("--soften", Dimension::fraction);
    at_place("--soften", [&] { require_softening(factor); });
    SoftenedContact soft{
        .factor = factor, .pair = softened(pair, factor), .damping = {}, .parameters = {}, .dampings = {}};
    if (damping) soft.damping = softened(*damping, pair, factor);
    ContactPair yielding = pair;
    yielding.yield_pressure = 1;
    soft.parameters.emplace_back("yield_pressure", softened(yielding, factor).yield_pressure);
    for (const LawParameter& parameter : law_parameters())
        soft.parameters.emplace_back(parameter.name, softening_of(parameter, factor));
    for (const DampingLaw law : all_values<DampingLaw>)
        soft.dampings.emplace_back(name_of(law), softening_of(law, pair, factor));
    return soft;
}

Json softened_json(const SoftenedContact& soft) {
    Json json{
        {"factor", soft.factor},
        {"stretch", stretch_of(soft.factor)},
        {"contact_modulus", quantity_json(soft.pair.contact_modulus, Dimension::pressure)},
        {"work_of_adhesion", quantity_json(soft.pair.work_of_adhesion, Dimension::energy_per_area)},
        {"greatest_velocity", quantity_json(greatest_softened_velocity(soft.pair), Dimension::velocity)},
        {"parameter_factors", Json::object()},
        {"damping_factors", Json::object()}};
    if (soft.damping) json["damping"] = quantity_json(soft.damping->coefficient, unit_of(soft.damping->law));
    for (const auto& [name, factor] : soft.parameters) json["parameter_factors"][name] = factor;
    for (const auto& [name, factor] : soft.dampings) json["damping_factors"][name] = factor;
    return json;
}

void add_softened(TextList& list, const SoftenedContact& soft) {
    const auto factors = [](const std::vector<std::pair<std::string, double>>& all) {
        std::vector<std::string> words;
        words.reserve(all.size());
        for (const auto& [name, factor] : all)
            words.push_back(fmt::format("{} times {}", name, readable_number(factor)));
        return joined(words);
    };
    list.add(fmt::format("softened by {}", shortest(soft.factor)),
             fmt::format("the same e and v_c; contacts last and overlap {} times as much",
                         readable_number(stretch_of(soft.factor))));
    list.add("  E*", readable(soft.pair.contact_modulus, "Pa"));
    list.add("  w", readable(soft.pair.work_of_adhesion, "J/m2"));
    if (soft.damping)
        list.add("  damping",
                 fmt::format("{} ({})", readable(soft.damping->coefficient, unit_of(soft.damping->law)),
                             name_of(soft.damping->law)));
    list.add("  parameters of laws", factors(soft.parameters));
    list.add("  damping, by its law", factors(soft.dampings));
    list.add("  up to", fmt::format("{}, where a Hertz impact overlaps by {} % of R*",
                                    readable(greatest_softened_velocity(soft.pair), "m/s"),
                                    readable_number(100 * greatest_softened_overlap)));
}

}  // namespace ashimpact
