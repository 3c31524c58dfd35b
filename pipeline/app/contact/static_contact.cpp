// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/contact/static_contact.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/files/file.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/registry.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// Radii at which --pressure lists the pressure: a at the last, where that of JKR is minus infinity, is left
/// out.
constexpr int pressure_points = 200;

std::string pressure_csv(const PressureProfile& profile) {
    std::string csv = "radius [m],pressure [Pa]\n";
    for (int i = 0; i < pressure_points; ++i) {
        const double radius = profile.contact_radius * i / pressure_points;
        csv += shortest(radius) + "," + shortest(profile.at(radius)) + "\n";
    }
    return csv;
}

/// The contact radii that the options name, the stable one first [m].
std::vector<double> read_radii(const CommandOptions& options, const StaticCurve& curve,
                               const ContactPair& pair) {
    if (options.has("--contact-radius")) {
        const double radius = options.positive("--contact-radius", Dimension::length);
        if (radius < curve.first().contact_radius)
            throw InputError(readable(radius, "m") + " is below the fold, where the contact breaks",
                             readable(curve.first().contact_radius, "m") + " or more")
                .at("--contact-radius");
        return {radius};
    }
    const double force = options.number("--force", Dimension::force);
    const auto radii = jkr_radii(pair, force);
    const double tension = 1.5 * std::numbers::pi * pair.work_of_adhesion * pair.effective_radius;
    if (radii.empty())
        throw InputError(readable(force, "N") + " tears the contact off",
                         "above the greatest tension, -(3/2) pi w R* = " + readable(-tension, "N"))
            .at("--force");
    return radii;
}

}  // namespace

void add_static_options(Command& command) {
    command.add("--contact-radius", "Q",
                "a of the JKR contact at rest: force, overlap, pressure (Eqs. 15-20)");
    command.add("--force", "Q", "on that contact instead, positive where it presses; both radii of Eq. 15");
    command.add("--pressure", "FILE", "p(r) of that contact (Eqs. 3, 17) as CSV");
}

void add_static_contacts(const CommandOptions& options, const ContactChoice& contact, Json& json,
                         TextList& list, std::vector<Finding>& findings) {
    const ContactPair& pair = contact.contact;
    const auto judge = [&](const std::vector<double>& radii) {
        const double widest = radii.empty() ? 0 : *std::ranges::max_element(radii);
        if (const auto finding = wide_contact_finding(widest / pair.effective_radius))
            findings.push_back(*finding);
    };
    const bool by_force = options.has("--force");
    if (!by_force && !options.has("--contact-radius")) {
        if (options.has("--pressure"))
            throw InputError("belongs to a contact at rest", "with --contact-radius or --force")
                .at("--pressure");
        judge(jkr_radii(pair, 0));
        return;
    }
    if (by_force && options.has("--contact-radius"))
        throw InputError("both are given", "one of the two").at("--contact-radius, --force");
    const bool adhesive = pair.work_of_adhesion > 0;
    const StaticCurve curve(adhesive ? Law::of<Jkr>() : Law::of<Hertz>(), pair);
    json["static"] = Json::array();
    const double sphere = std::min(contact.sphere.radius, contact.partner.value_or(contact.sphere).radius);
    const std::vector<double> radii = read_radii(options, curve, pair);
    judge(radii);
    for (const double radius : radii) {
        if (radius > sphere)
            throw InputError(
                fmt::format("the contact has a radius of {}, which is more than that of the sphere",
                            readable(radius, "m")),
                "a contact radius up to " + readable(sphere, "m"))
                .at(by_force ? "--force" : "--contact-radius");
        const StaticPoint point = curve.at_contact_radius(radius);
        const PressureProfile profile = jkr_pressure(pair, radius);
        const bool stable = json["static"].empty();
        if (stable && options.has("--pressure")) write_file(options["--pressure"], pressure_csv(profile));
        json["static"].push_back(
            {{"contact_radius", quantity_json(radius, Dimension::length)},
             {"overlap", quantity_json(point.overlap, Dimension::length)},
             {"force", quantity_json(point.force(), Dimension::force)},
             {"repulsive_force", quantity_json(point.repulsive_force, Dimension::force)},
             {"attractive_force", quantity_json(point.attractive_force, Dimension::force)},
             {"hertz_pressure", quantity_json(profile.hertz_pressure, Dimension::pressure)},
             {"rim_tension", quantity_json(profile.rim_tension, Dimension::pressure)},
             {"tension_ratio",
              quantity_json(profile.rim_tension / profile.hertz_pressure, Dimension::fraction)},
             {"neutral_radius", quantity_json(profile.neutral_radius(), Dimension::length)}});
        list.add(stable ? "a, contact radius" : "a, on the unstable branch", readable(radius, "m"));
        list.add("overlap", readable(point.overlap, "m"));
        list.add("force",
                 fmt::format("{} = {} {}", readable(point.force(), "N"), readable(point.repulsive_force, "N"),
                             readable(point.attractive_force, "N")));
        list.add("pressure",
                 fmt::format("p0 {}, p0' {}, positive up to r_c {}", readable(profile.hertz_pressure, "Pa"),
                             readable(profile.rim_tension, "Pa"), readable(profile.neutral_radius(), "m")));
    }
    if (!adhesive) return;
    const double line = std::cbrt(6.0 * pair.work_of_adhesion * pair.work_of_adhesion *
                                  pair.effective_radius * pair.contact_modulus / std::numbers::pi);
    json["line_force"] = {{"value", line}, {"unit", "N/m"}};
    list.add("f of Eq. 14", readable(line, "N/m"));
}

}  // namespace ashimpact
