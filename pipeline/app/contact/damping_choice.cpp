// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/contact/damping_choice.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/layout.hpp"
#include "solver/dem/requested_restitution.hpp"

namespace ashimpact {

namespace {

/// The restitution that is asked for.
double read_restitution(const CommandOptions& options) {
    constexpr auto option = "--damping-restitution";
    const double restitution = options.number(option, Dimension::fraction);
    if (!(restitution > 0 && restitution <= 1))
        throw InputError("is " + shortest(restitution), "above 0, up to 1").at(option);
    return restitution;
}

/// The velocity at which it is asked for; none if no velocity counts.
std::optional<double> read_velocity(const CommandOptions& options, DampingLaw law,
                                    const ContactPair& contact) {
    if (restitution_depends_on_velocity(law, contact)) {
        if (!options.has("--at"))
            throw InputError(fmt::format("is missing: by damping law '{}' the restitution depends on the "
                                         "velocity",
                                         name_of(law)),
                             "the velocity at which --damping-restitution holds, such as \"2 m/s\"")
                .at("--at");
        return options.positive("--at", Dimension::velocity);
    }
    if (options.has("--at"))
        spdlog::warn(
            "warning: --at: by damping law '{}' the restitution is the same at every velocity, so it "
            "changes nothing",
            name_of(law));
    return std::nullopt;
}

}  // namespace

DampingChoice read_damping_choice(const CommandOptions& options, const ContactPair& contact) {
    const Damping given = read_damping(options, contact);
    if (!options.has("--damping-restitution")) {
        if (options.has("--at"))
            throw InputError("belongs to --damping-restitution", "both, or --damping").at("--at");
        return {given};
    }
    if (options.has("--damping"))
        throw InputError("both are given", "one of the two").at("--damping, --damping-restitution");
    const RequestedRestitution requested{read_restitution(options),
                                         read_velocity(options, given.law, contact)};
    const bool is_cut = options["--detachment"] == name_of(Detachment::zero_force);
    const Damping damping = at_place("--damping-restitution", [&] {
        return damping_without_adhesion(given.law, is_cut ? Detachment::zero_force : Detachment::zero_overlap,
                                        contact, requested.velocity.value_or(1), requested.restitution);
    });
    return {damping, requested};
}

std::string requested_words(const RequestedRestitution& requested, const Damping& damping) {
    return fmt::format(
        "damping {} {}, for restitution {} {} without adhesion and yield", name_of(damping.law),
        readable(damping.coefficient, unit_of(damping.law)), shortest(requested.restitution),
        requested.velocity ? "at " + readable(*requested.velocity, "m/s") : std::string("at every velocity"));
}

void add_requested(Json& json, const DampingChoice& choice) {
    if (!choice.requested) return;
    Json codes = Json::array();
    for (const CodeRestitution& code : restitution_in_codes(choice.requested->restitution))
        codes.push_back({{"code", code.code},
                         {"setting", code.setting},
                         {"detachment", name_of(code.end)},
                         {"restitution", quantity_json(code.restitution, Dimension::fraction)}});
    json["damping_restitution"] = {
        {"requested", quantity_json(choice.requested->restitution, Dimension::fraction)},
        {"velocity", quantity_json(choice.requested->velocity, Dimension::velocity)},
        {"damping_law", name_of(choice.damping.law)},
        {"damping", quantity_json(choice.damping.coefficient, unit_of(choice.damping.law))},
        {"codes", codes}};
}

std::string requested_text(const DampingChoice& choice) {
    if (!choice.requested) return "";
    TextList list;
    list.add("damping for a restitution",
             fmt::format("{} without adhesion and yield{}", shortest(choice.requested->restitution),
                         choice.requested->velocity ? " at " + readable(*choice.requested->velocity, "m/s")
                                                    : std::string(", at every velocity")));
    for (const CodeRestitution& code : restitution_in_codes(choice.requested->restitution))
        list.add(fmt::format("  {} asked for it", code.code),
                 fmt::format("{} by {}", readable_number(code.restitution), code.setting));
    return list.text(0);
}

}  // namespace ashimpact
