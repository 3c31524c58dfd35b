// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/contact/oblique_choice.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Words for a reader. @param result of an impact with friction
std::string regime_words(const ObliqueResult& result, double friction) {
    if (friction == 0 && result.tangential.regime != SlidingRegime::captured)
        return "slides freely: nothing acts along the wall";
    switch (result.tangential.regime) {
        case SlidingRegime::sliding:
            return "slides throughout";
        case SlidingRegime::rolling:
            return "slides, then rolls";
        case SlidingRegime::captured:
            return "captured: it stays, whatever its velocity along the wall";
        default:
            return "no sliding";
    }
}

}  // namespace

std::optional<double> read_angle(const CommandOptions& options) {
    if (!options.has("--angle")) return std::nullopt;
    const double angle = options.number("--angle", Dimension::angle);
    if (angle >= 0 && angle < std::numbers::pi / 2) return angle;
    throw InputError(fmt::format("{} is {:.10g} degrees from the normal", options["--angle"], angle / degree),
                     "0 to below 90 degrees, such as \"45 deg\"; a number alone is in radians")
        .at("--angle");
}

std::optional<ObliqueChoice> read_oblique(const CommandOptions& options, double velocity) {
    const auto angle = read_angle(options);
    const bool sideways = options.has("--tangential-velocity");
    if (angle && sideways)
        throw InputError("both are given", "one of the two").at("--angle, --tangential-velocity");
    if (!angle && !sideways && !options.has("--spin")) {
        if (options.has("--friction"))
            warn_idle("--friction", "the impact is normal and without spin (--angle, --tangential-velocity)");
        return std::nullopt;
    }
    ObliqueChoice choice{.normal_velocity = velocity};
    if (!options.has("--friction"))
        throw InputError("is missing", "the coefficient of friction, such as 0.1; 0 for none")
            .at("--friction");
    choice.friction = options.number("--friction", Dimension::fraction);
    at_place("--friction", [&] { require_not_negative("friction", choice.friction, Dimension::fraction); });
    if (angle) {
        choice.normal_velocity = velocity * std::cos(*angle);
        choice.tangential.velocity = velocity * std::sin(*angle);
    } else if (sideways) {
        choice.tangential.velocity = options.number("--tangential-velocity", Dimension::velocity);
    }
    if (options.has("--spin")) choice.tangential.spin = options.number("--spin", Dimension::angular_velocity);
    return choice;
}

ContactBodies bodies_of(const ContactChoice& choice) {
    return {.sphere = choice.sphere, .partner = choice.partner};
}

void add_oblique(Json& json, const ObliqueImpact& impact, const ObliqueResult& result) {
    const auto joule = [](double value) { return quantity_json(value, Dimension::energy); };
    const auto number = [](const std::optional<double>& value) {
        return quantity_json(value, Dimension::fraction);
    };
    const TangentialMotion& before = impact.tangential;
    const bool captured = result.tangential.regime == SlidingRegime::captured;
    json["contact_regime"] = json["regime"];
    json["regime"] = name_of(result.tangential.regime);
    json["friction"] = impact.friction;
    json["angle"] =
        quantity_json(std::atan2(std::abs(before.velocity), impact.normal.velocity), Dimension::angle);
    json["tangential_velocity"] = quantity_json(before.velocity, Dimension::velocity);
    json["incident_spin"] = quantity_json(before.spin, Dimension::angular_velocity);
    json["tangential_restitution"] = number(result.tangential_restitution);
    json["rebound_angle"] = quantity_json(result.rebound_angle, Dimension::angle);
    json["rebound_tangential_velocity"] = quantity_json(
        captured ? std::nullopt : std::optional(result.tangential.after.velocity), Dimension::velocity);
    json["spin"] = quantity_json(captured ? std::nullopt : std::optional(result.tangential.after.spin),
                                 Dimension::angular_velocity);
    json["impulse_ratio"] = number(result.impulse_ratio);
    json["repulsive_impulse"] = quantity_json(result.repulsive_impulse, Dimension::impulse);
    json["energy"].update({{"incident_sliding", joule(result.before.sliding)},
                           {"incident_spin", joule(result.before.spin)},
                           {"remaining_sliding", joule(result.after.sliding)},
                           {"remaining_spin", joule(result.after.spin)},
                           {"friction", joule(result.tangential.friction_work)},
                           {"stopped", joule(result.stopped)}});
}

std::string oblique_text(const ObliqueImpact& impact, const ObliqueResult& result) {
    const auto degrees = [](double angle) {
        return readable_number(angle / degree) + " degrees from the normal";
    };
    TextList list;
    list.add("angle", degrees(std::atan2(std::abs(impact.tangential.velocity), impact.normal.velocity)));
    list.add("friction", fmt::format("mu = {}: {}", readable_number(impact.friction),
                                     regime_words(result, impact.friction)));
    if (result.rebound_angle) {
        list.add("rebound angle", degrees(*result.rebound_angle));
        if (result.tangential_restitution)
            list.add("tangential restitution", readable_number(*result.tangential_restitution));
        list.add("spin", readable(result.tangential.after.spin, "rad/s"));
        list.add("impulse ratio", readable_number(*result.impulse_ratio));
        list.add("lost in sliding", readable(result.tangential.friction_work, "J"));
    } else if (result.stopped > 0) {
        list.add("lost along the wall", readable(result.stopped, "J"));
    }
    return list.text(0);
}

void add_at_angle(Json& json, double angle, const std::optional<double>& normal) {
    json["angle"] = quantity_json(angle, Dimension::angle);
    json["normal_critical_velocity"] = json["critical_velocity"];
    json["critical_velocity"] =
        quantity_json(normal ? std::optional(*normal / std::cos(angle)) : std::nullopt, Dimension::velocity);
    if (const auto crossings = json.find("crossings"); crossings != json.end() && crossings->is_object())
        for (Json& velocity : (*crossings)["values"]) velocity = velocity.get<double>() / std::cos(angle);
}

std::string at_angle_text(double angle, const std::optional<double>& normal) {
    if (!normal) return {};
    TextList list;
    list.add(fmt::format("at {} degrees", readable_number(angle / degree)),
             outside_model(*normal)
                 ? value_text(*normal, "m/s")
                 : fmt::format("{}, of which {} is normal to the wall",
                               readable(*normal / std::cos(angle), "m/s"), value_text(*normal, "m/s")));
    return list.text(0);
}

}  // namespace ashimpact
