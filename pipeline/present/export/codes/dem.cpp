// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/codes/dem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/present/export/expected.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

constexpr double captured_horizon = 8;   // Hertz contacts after which a captured sphere is still there
constexpr double rebound_horizon = 1.5;  // contacts
constexpr double slow_horizon = 4;       // near v_c, where a finite time step makes the contact longer
constexpr double slow_restitution = 0.02;
constexpr int captured_every = 50;   // steps between two rows of output; a rebound needs every step
constexpr int pair_every = 5;        // times as many: its steps are shorter
constexpr double cloud_steps = 200;  // of the shortest contact
constexpr double cloud_horizon = 6;  // of the longest contact

bool is(const ExportSubject& subject, std::string_view law) {
    return subject.law.name() == law;
}

double hertz_time(const ExportSubject& subject, double diameter, double velocity) {
    return hertz_contact_time(contact_at(subject, diameter), velocity);
}

/// Steps to run, in contacts.
double horizon_of(const ExpectedImpact& impact) {
    if (impact.outcome == Outcome::capture) return captured_horizon;
    return impact.restitution < slow_restitution ? slow_horizon : rebound_horizon;
}

/// Damping coefficient at the velocity f_ash_memory, a sum of ramps through the nodes, cut into lines.
std::string velocity_curve(const std::vector<DampingNode>& nodes) {
    constexpr std::size_t ramps_a_line = 6;
    std::string lines;
    std::string sum = exact(nodes.front().coefficient);
    double slope_before = 0;
    std::size_t part = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool last = i + 1 == nodes.size();
        const double slope = last ? 0
                                  : (nodes[i + 1].coefficient - nodes[i].coefficient) /
                                        (nodes[i + 1].velocity - nodes[i].velocity);
        sum += fmt::format(" + ({})*(f_ash_memory>{})*(f_ash_memory-{})", exact(slope - slope_before),
                           exact(nodes[i].velocity), exact(nodes[i].velocity));
        slope_before = slope;
        if ((i + 1) % ramps_a_line == 0 || last) {
            lines += fmt::format("variable         ash_curve{} atom \"{}\"\n", part, sum);
            sum = fmt::format("v_ash_curve{}", part++);
        }
    }
    return lines + fmt::format("variable         ash_curve atom \"{}\"\n", sum);
}

/// Keeps the velocity of approach of each particle during its contact, as f_ash_memory. A variable would be
/// parsed again at each use.
std::string impact_memory() {
    return "variable         ash_impact atom \"-vz\"\n"
           "run              0\n"
           "fix              ash_memory all store/state 1 v_ash_impact\n"
           "variable         ash_impact atom \"(v_ash_overlap<=0)*(-vz) + "
           "(v_ash_overlap>0)*f_ash_memory\"\n";
}

std::string damping_variable(const ExportSubject& subject) {
    const SizedDamping& damping = subject.damping;
    std::string lines;
    std::string formula = exact(damping.nodes.front().coefficient);
    if (damping.depends_on_velocity()) {
        lines = impact_memory() + velocity_curve(damping.nodes);
        formula = "v_ash_curve";
    }
    if (damping.exponent != 0)
        formula += fmt::format("*(2*c_ash_radius/{})^({})", exact(damping.reference_diameter),
                               exact(damping.exponent));
    if (damping.law == DampingLaw::contact_radius) formula += "*sqrt(c_ash_radius*v_ash_depth)";
    if (damping.law == DampingLaw::tsuji)
        formula += fmt::format("*sqrt(mass*{}*sqrt(c_ash_radius))*sqrt(sqrt(v_ash_depth))",
                               exact(4.0 / 3.0 * subject.contact.contact_modulus));
    return lines + fmt::format("variable         ash_damping atom \"{}\"\n", formula);
}

/// Attraction on a sphere in contact, positive [N].
std::string attraction_formula(const ExportSubject& subject) {
    const double w = subject.contact.work_of_adhesion;
    if (is(subject, "dmt")) return fmt::format("2*PI*{}*c_ash_radius", exact(w));
    if (is(subject, "sjkr"))
        return fmt::format("PI*{}*c_ash_radius*v_ash_depth",
                           exact(subject.contact.parameters[cohesion_energy_density]));
    const double cube =
        6 * w * w * subject.contact.contact_modulus;  // 2 pi f sqrt(R delta), f^3 = 6 w^2 R E*/pi
    return fmt::format("2*PI*({}*c_ash_radius/PI)^(1/3)*sqrt(c_ash_radius*v_ash_depth)", exact(cube));
}

/// Makes the damping second order in the time step.
std::string lag_correction() {
    return "# Velocity Verlet gives the damping the velocity half a step back, as if the mass were m - eta "
           "dt/2. This force\n# takes the error out: it divides the forces that stand above it by 1 + eta "
           "dt/(2 m).\n"
           "variable         ash_share atom \"(v_ash_overlap>=0)*v_ash_damping*dt/(2*mass)\"\n"
           "variable         ash_lag atom \"fz/(1 + v_ash_share) - fz\"\n"
           "fix              ash_lag all addforce 0 0 v_ash_lag\n";
}

/// Powers of the time step in the error of the restitution. Apart from a constant, the force begins and ends
/// with overlap^a, a the least power in it, and at such an end Verlet's steps leave an error of the power 1 +
/// a.
Json powers_of(const ExportSubject& subject, const DemCheck& check) {
    const bool damped = !subject.damping.is_zero();
    const bool tsuji = subject.damping.law == DampingLaw::tsuji;
    if (damped && check.damping_lags) return tsuji ? Json{1, 2, 2.5, 3} : Json{1, 2, 3, 4};
    if (damped && tsuji) return {1.25, 1.5, 2, 2.25};
    const bool square_root =
        is(subject, "brach-dunn") || (damped && subject.damping.law == DampingLaw::contact_radius);
    return square_root ? Json{1.5, 2, 2.5, 3} : Json{2, 2.5, 3.5, 4};
}

template <class Value>
std::string list_of(const std::vector<ExpectedImpact>& impacts, std::string_view name, Value&& value) {
    std::string line = fmt::format("variable         {} index", name);
    for (const ExpectedImpact& impact : impacts) line += " " + value(impact);
    return line + "\n";
}

}  // namespace

bool attracts(const ExportSubject& subject) {
    return subject.law.uses_work_of_adhesion() || is(subject, "sjkr");
}

void require_added_forces(const ExportSubject& subject, std::string_view code) {
    if (const auto reason = added_forces_refusal(subject))
        throw InputError(
            fmt::format("{}: {}", code, *reason),
            "hertz, dmt, brach-dunn, sjkr with zero-overlap; damping constant, contact-radius, tsuji");
}

std::optional<std::string> added_forces_refusal(const ExportSubject& subject) {
    if (!is(subject, "hertz") && !is(subject, "dmt") && !is(subject, "brach-dunn") && !is(subject, "sjkr"))
        return fmt::format("its walls know no {}", subject.law.name());
    const bool zero_force = subject.detachment == Detachment::zero_force;
    if (subject.detachment != Detachment::zero_overlap && !zero_force)
        return fmt::format("its walls let go at zero overlap, not at {}", name_of(subject.detachment));
    const SizedDamping& damping = subject.damping;
    const bool known = damping.law == DampingLaw::constant || damping.law == DampingLaw::contact_radius ||
                       damping.law == DampingLaw::tsuji;
    if (!known) return fmt::format("it has no damping law {}", name_of(damping.law));
    if (zero_force && !damping.is_zero())
        return "its walls do not let go where the force of contact and damping is zero; zero-overlap does it";
    return std::nullopt;
}

std::string added_forces(const ExportSubject& subject, bool attraction, bool damping) {
    const bool damped = !subject.damping.is_zero();
    if (!attraction && !damped) return "";
    std::string lines =
        "compute          ash_radius all property/atom radius\n"
        "variable         ash_overlap atom \"c_ash_radius - z + v_ash_wall_z\"\n"
        "variable         ash_depth atom \"v_ash_overlap*(v_ash_overlap>0)\"\n";
    if (damped) lines += damping_variable(subject);
    std::string force = damped && damping ? "-v_ash_damping*vz" : "";
    if (attraction) {
        lines += fmt::format("variable         ash_attraction atom \"{}\"\n", attraction_formula(subject));
        force += (force.empty() ? "-" : " - ") + std::string("v_ash_attraction");
    }
    if (!force.empty())
        lines += fmt::format("variable         ash_force atom \"(v_ash_overlap>=0)*({})\"\n", force) +
                 "fix              ash_force all addforce 0 0 v_ash_force\n";
    return damped ? lines + lag_correction() : lines;
}

std::vector<std::string> added_force_conversions(const ExportSubject& subject, bool attraction,
                                                 bool damping) {
    std::vector<std::string> lines;
    if (attraction)
        lines.emplace_back(
            is(subject, "dmt") ? "attraction 2 pi w R* while in contact, by `fix addforce`"
            : is(subject, "sjkr")
                ? "attraction pi k_c R* overlap, by `fix addforce`; `cohesion sjkr` of LIGGGHTS takes the "
                  "area "
                  "in which sphere and wall intersect, pi (2 R overlap - overlap^2), and needs k_c/2 for it"
                : "attraction 2 pi f sqrt(R* overlap), f = (6 w^2 R* E*/pi)^(1/3), by `fix addforce`");
    if (damping)
        lines.emplace_back("damping force -eta v on the normal velocity while in contact, by `fix addforce`");
    if (damping && subject.damping.depends_on_velocity())
        lines.emplace_back(
            "eta follows the velocity of approach, which `fix store/state` keeps for as long as the contact "
            "lasts");
    return lines;
}

ExportFile impact_variables(const ExportSubject& subject) {
    const auto impacts = expected_impacts(subject);
    const auto is_capture = [](const ExpectedImpact& each) { return each.outcome == Outcome::capture; };
    std::size_t number = 0;
    std::string text = "# The impacts of expected.json; SI units.\n";
    text += list_of(impacts, "number", [&](const ExpectedImpact&) { return std::to_string(++number); });
    text += list_of(impacts, "diameter", [](const ExpectedImpact& each) { return exact(each.diameter); });
    text += list_of(impacts, "mass",
                    [&](const ExpectedImpact& each) { return exact(particle_mass(subject, each.diameter)); });
    text += list_of(impacts, "velocity", [](const ExpectedImpact& each) { return exact(each.velocity); });
    text += list_of(impacts, "contact_time", [&](const ExpectedImpact& each) {
        return exact(each.contact_time.value_or(hertz_time(subject, each.diameter, each.velocity)));
    });
    text += list_of(impacts, "horizon", [&](const ExpectedImpact& each) { return exact(horizon_of(each)); });
    text += list_of(impacts, "every", [&](const ExpectedImpact& each) {
        return std::to_string((is_capture(each) ? captured_every : 1) * (subject.partner ? pair_every : 1));
    });
    text += list_of(impacts, subject.partner ? "partner_z" : "ash_wall_z", [&](const ExpectedImpact& each) {
        if (!subject.partner) return exact(-each.diameter / 2);
        // Two spheres touch only where they are closer than the sum of their radii.
        const double touching = each.diameter / 2 + subject.partner->radius;
        return exact(-touching * (1 - 2 * std::numeric_limits<double>::epsilon()));
    });
    return {"impacts.in", text};
}

TemplateValues dem_values(const ExportSubject& subject) {
    double fastest = 0;
    double shortest_contact = std::numeric_limits<double>::infinity();
    double longest_contact = 0;
    for (const ExpectedImpact& each : expected_impacts(subject)) {
        fastest = std::max(fastest, each.velocity);
        shortest_contact = std::min(shortest_contact, each.contact_time.value_or(shortest_contact));
        longest_contact = std::max({longest_contact, each.contact_time.value_or(0),
                                    hertz_time(subject, each.diameter, each.velocity)});
    }
    if (!std::isfinite(shortest_contact)) shortest_contact = longest_contact;
    TemplateValues values = common_values(subject);
    const double size = subject.to_diameter + (subject.partner ? 2 * subject.partner->radius : 0);
    values.merge(TemplateValues{{"box", exact(5 * size)},
                                {"skin", exact(0.05 * subject.from_diameter)},
                                {"shortest", readable(shortest_contact, "s")},
                                {"fastest", exact(fastest)},
                                {"time_step", exact(shortest_contact / cloud_steps)},
                                {"steps", fmt::format("{:.0f}", std::ceil(cloud_horizon * longest_contact /
                                                                          shortest_contact * cloud_steps))},
                                {"cloud_box", exact(100 * size)},
                                {"cloud_top", exact(1000 * size)},
                                {"young_modulus", exact(2 * subject.contact.contact_modulus)},
                                {"stiffness", exact(4.0 / 3.0 * subject.contact.contact_modulus)}});
    return values;
}

ExportFile dem_expected(const ExportSubject& subject, const DemCheck& check) {
    Json more{{"log", "log.impacts"}, {"powers", powers_of(subject, check)}, {"tolerance", check.tolerance}};
    if (check.free_flight) more["end"] = "free-flight";
    return expected_json(subject, check.code, more);
}

}  // namespace ashimpact
