// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/present/export/codes/deck.hpp"

namespace ashimpact {

namespace {

constexpr double liggghts_tolerance = 1e-5;
constexpr DemCode liggghts{.name = "LIGGGHTS",
                           .program = "liggghts",
                           .command = "liggghts -in in.impacts -log log.impacts -screen none -echo none",
                           .tried = "LIGGGHTS-PUBLIC 3.8.0 (Debian 12: liggghts)",
                           .setup =
                               "hard_particles   yes                            # Young's moduli above "
                               "1e9 Pa\natom_style       granular\ncommunicate      single vel yes\n",
                           .sets_mass = false};

void require_liggghts(const ExportSubject& subject) {
    if (subject.law.name() == "jkr")
        throw InputError(
            "LIGGGHTS has no JKR: its `cohesion sjkr` is an energy density times an area, law sjkr",
            "hertz, dmt, brach-dunn, sjkr")
            .at("--law");
    require_added_forces(subject, liggghts.name);
}

std::string liggghts_wall_file(const ExportSubject& subject) {
    return fmt::format(
               "# Ash on the wall z = ash_wall_z: law {}, contact ends at zero overlap. Needs the variable "
               "ash_wall_z, and\n# ash_material.in before. The wall gives the Hertz repulsion alone.\n"
               "fix              ash_wall all wall/gran model hertz tangential off primitive type 1 zplane "
               "${{ash_wall_z}}\n",
               subject.law.name()) +
           added_forces(subject, attracts(subject), !subject.damping.is_zero());
}

std::vector<std::string> liggghts_conversions(const ExportSubject& subject) {
    std::vector<std::string> lines{
        "`model hertz` with youngsModulus 2 E* and nu = 0 for sphere and wall: effective modulus E*",
        "coefficientRestitution 1: no damping of the code's own, which would follow another law",
        "R* is the radius of the sphere: the wall is flat"};
    const auto added = added_force_conversions(subject, attracts(subject), !subject.damping.is_zero());
    lines.insert(lines.end(), added.begin(), added.end());
    return lines;
}

void require_liggghts_pair(const ExportSubject& subject) {
    require_pair_contact(subject, liggghts, false);
    if (!subject.one_size() && (subject.law.name() == "dmt" || !subject.damping.is_zero()))
        throw InputError(
            "LIGGGHTS: its `model edinburgh` takes attraction and damping as numbers of two types, which are "
            "others for each size",
            "one size, or hertz without damping")
            .at("--from-diameter, --to-diameter");
}

/// The coefficient of restitution c by which `model edinburgh` knows the damping eta:
/// eta = 2 sqrt(m* k) L/sqrt(L^2 + pi^2), L = -ln c, k = (4/3) E* sqrt(R*). It is not e.
double edinburgh_restitution(const ExportSubject& subject, const ContactPair& contact) {
    const double greatest = 2 * std::sqrt(contact.mass * hertz_stiffness(contact));
    const double share = pair_damping(subject) / greatest;
    if (share >= 1)
        throw InputError(
            "LIGGGHTS: no coefficient of restitution of its `model edinburgh` gives that damping",
            "less than " + exact(greatest) + " kg/s")
            .at("--damping");
    return std::exp(-std::numbers::pi * share / std::sqrt(1 - share * share));
}

std::string liggghts_pair_file(const ExportSubject& subject) {
    const ContactPair contact = contact_at(subject, subject.from_diameter);
    const double attraction = subject.law.name() == "dmt"
                                  ? 2 * std::numbers::pi * contact.work_of_adhesion * contact.effective_radius
                                  : 0.0;
    return filled("liggghts/ash_pair.in", {{"law", std::string(subject.law.name())},
                                           {"young_modulus", exact(2 * contact.contact_modulus)},
                                           {"restitution", exact(edinburgh_restitution(subject, contact))},
                                           {"pull_off_force", exact(-attraction)}});
}

ExportFolder liggghts_pair_folder(const ExportSubject& subject) {
    require_liggghts_pair(subject);
    TemplateValues values = dem_values(subject);
    values["own_input"] = "`include ash_pair.in`; with more than one type its lists want more entries.";
    return deck_folder(
        subject, liggghts,
        {.contact = "neigh_modify     delay 0\ninclude          ash_pair.in\n"
                    "fix              integrate all nve/sphere\n",
         .files = {{"ash_pair.in", liggghts_pair_file(subject)}},
         .conversions = {"`model edinburgh` with overlapExponent 1.5, UnloadingStiffness 1 and limitForce "
                         "off: Hertz with constant damping and constant attraction; youngsModulus 2 E* with "
                         "nu = 0 for both",
                         "coefficientRestitution c gives eta = 2 sqrt(m* k) L/sqrt(L^2 + pi^2), L = -ln c, "
                         "k = (4/3) E* sqrt(R*); it is not e",
                         "pullOffForce = -2 pi w R* under dmt"},
         .check = {.code = "liggghts", .tolerance = liggghts_tolerance, .damping_lags = true}},
        values);
}

}  // namespace

ExportFolder liggghts_folder(const ExportSubject& subject) {
    if (subject.partner) return liggghts_pair_folder(subject);
    require_liggghts(subject);
    TemplateValues values = dem_values(subject);
    values["cloud_words"] = "";
    return deck_folder(subject, liggghts,
                       {.contact = "neigh_modify     delay 0\ninclude          ash_material.in\n"
                                   "fix              integrate all nve/sphere\n"
                                   "include          ash_wall.in\n",
                        .files = {{"ash_material.in", filled("liggghts/ash_material.in", values)},
                                  {"ash_wall.in", liggghts_wall_file(subject)}},
                        .conversions = liggghts_conversions(subject),
                        .check = {.code = "liggghts", .tolerance = liggghts_tolerance}},
                       values);
}

}  // namespace ashimpact
