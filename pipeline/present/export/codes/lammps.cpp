// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/present/export/codes/deck.hpp"

namespace ashimpact {

namespace {

constexpr double lammps_tolerance = 1e-6;
constexpr DemCode lammps{.name = "LAMMPS",
                         .program = "lmp",
                         .command = "lmp -in in.impacts -log log.impacts -screen none -nocite",
                         .tried = "LAMMPS of 2022-01-06 (Debian 12: lammps), package GRANULAR",
                         .setup = "atom_style       sphere\n",
                         .sets_mass = true};

/// Which forces of a wall somebody computes.
struct Forces {
    bool attraction;
    bool damping;
};

/// What `fix wall/gran granular` of this version does itself.
Forces own_forces(const ExportSubject& subject) {
    const SizedDamping& damping = subject.damping;
    return {.attraction = subject.law.name() == "dmt",
            .damping = damping.law == DampingLaw::constant && !damping.depends_on_velocity() &&
                       damping.exponent == 0};
}

/// The rest, which goes through added_forces().
Forces added_to(const Forces& own, const ExportSubject& subject) {
    return {.attraction = attracts(subject) && !own.attraction,
            .damping = !own.damping && !subject.damping.is_zero()};
}

void require_lammps(const ExportSubject& subject) {
    if (subject.law.name() == "jkr")
        throw InputError("LAMMPS of Debian 12 gives NaN for JKR on a wall past pull-off",
                         "hertz, dmt, brach-dunn, sjkr")
            .at("--law");
    require_added_forces(subject, lammps.name);
}

std::string wall(const ExportSubject& subject, const Forces& own) {
    const double modulus = subject.contact.contact_modulus;
    const std::string damping = exact(own.damping ? subject.damping.nodes.front().coefficient : 0);
    const std::string model = own.attraction
                                  ? fmt::format("dmt {} {} 0 {}", exact(2 * modulus), damping,
                                                exact(subject.contact.work_of_adhesion / 2))
                                  : fmt::format("hertz {} {}", exact(4.0 / 3.0 * modulus), damping);
    return fmt::format(
        "fix              ash_wall all wall/gran granular {} tangential linear_nohistory 0 0 damping "
        "velocity "
        "zplane ${{ash_wall_z}} NULL\n",
        model);
}

std::string lammps_wall_file(const ExportSubject& subject) {
    const Forces own = own_forces(subject);
    const Forces added = added_to(own, subject);
    return fmt::format(
               "# Ash on the wall z = ash_wall_z: law {}, contact ends at zero overlap. Needs the variable "
               "ash_wall_z.\n# `damping velocity` must stand there: the default, viscoelastic, is another "
               "law. E = 2 E* and nu = 0: the\n# effective modulus of a wall is E/(2(1 - nu)) in this "
               "version. "
               "Its surface energy is w/2.\n",
               subject.law.name()) +
           wall(subject, own) + added_forces(subject, added.attraction, added.damping);
}

std::vector<std::string> lammps_conversions(const ExportSubject& subject) {
    const Forces own = own_forces(subject);
    std::vector<std::string> lines{
        own.attraction
            ? "`dmt`: E = 2 E* with nu = 0, since its wall takes E/(2(1 - nu)) as effective modulus; "
              "surface energy gamma = w/2"
            : "`hertz`: K_n = (4/3) E*",
        "R* is the radius of the sphere: the wall is flat"};
    if (own.damping && !subject.damping.is_zero())
        lines.emplace_back("`damping velocity` with eta in kg/s: F_d = -eta v, as here");
    const Forces added = added_to(own, subject);
    const auto more = added_force_conversions(subject, added.attraction, added.damping);
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
}

/// The model of `pair_style granular`. A pair's effective modulus is E/(2(1 - nu^2)), that of E = 2 E*, nu =
/// 0.
std::string pair_model(const ExportSubject& subject) {
    const std::string_view law = subject.law.name();
    const double modulus = subject.contact.contact_modulus;
    const std::string damping = exact(pair_damping(subject));
    if (law == "hertz") return fmt::format("hertz {} {}", exact(4.0 / 3.0 * modulus), damping);
    return fmt::format("{} {} {} 0 {}", law, exact(2 * modulus), damping,
                       exact(subject.contact.work_of_adhesion / 2));
}

std::string lammps_pair_file(const ExportSubject& subject) {
    const bool jkr = subject.law.name() == "jkr";
    return fmt::format(
        "# Ash and its partner: law {}, contact ends at {}. Needs `pair_style granular` and the variables\n"
        "# ash_type and partner_type. `damping velocity` must stand there: the default, viscoelastic, is "
        "another law.\n{}pair_coeff       ${{ash_type}} ${{partner_type}} {} tangential {} damping "
        "velocity\n",
        subject.law.name(), name_of(subject.detachment),
        jkr ? "# Under jkr this version ends in an error with `linear_nohistory`.\n" : "",
        pair_model(subject), jkr ? "linear_history 0 0 0" : "linear_nohistory 0 0");
}

std::vector<std::string> lammps_pair_conversions(const ExportSubject& subject) {
    const std::string_view law = subject.law.name();
    std::vector<std::string> lines{
        law == "hertz" ? "`hertz`: K_n = (4/3) E*"
                       : fmt::format("`{}`: E = 2 E* with nu = 0, since a pair takes E/(2(1 - nu^2)) as "
                                     "effective modulus; surface energy gamma = w/2",
                                     law),
        "R* and m* are those that LAMMPS makes of the radii and masses of both"};
    if (!subject.damping.is_zero())
        lines.emplace_back(
            "`damping velocity` with eta in kg/s: F_d = -eta v of the relative velocity, as here");
    return lines;
}

ExportFolder lammps_pair_folder(const ExportSubject& subject) {
    require_pair_contact(subject, lammps, true);
    TemplateValues values = dem_values(subject);
    values["own_input"] =
        "`pair_style granular`, then `include ash_pair.in` with both types in `ash_type` and `partner_type`.";
    return deck_folder(subject, lammps,
                       {.contact = "comm_modify      vel yes cutoff " + values["skin"] +
                                   "\npair_style       granular\nvariable         ash_type index 1\n"
                                   "variable         partner_type index 1\ninclude          ash_pair.in\n"
                                   "fix              integrate all nve/sphere\n",
                        .files = {{"ash_pair.in", lammps_pair_file(subject)}},
                        .conversions = lammps_pair_conversions(subject),
                        .check = {.code = "lammps",
                                  .tolerance = lammps_tolerance,
                                  .damping_lags = true,
                                  .free_flight = subject.law.name() == "jkr"}},
                       values);
}

}  // namespace

ExportFolder lammps_folder(const ExportSubject& subject) {
    if (subject.partner) return lammps_pair_folder(subject);
    require_lammps(subject);
    TemplateValues values = dem_values(subject);
    values["cloud_words"] = "`in.cloud` throws many sizes at that wall. ";
    return deck_folder(subject, lammps,
                       {.contact = "pair_style       none\ncomm_modify      cutoff " + values["skin"] +
                                   "\nfix              integrate all nve/sphere\n"
                                   "include          ash_wall.in\n",
                        .files = {{"ash_wall.in", lammps_wall_file(subject)},
                                  {"in.cloud", filled("lammps/in.cloud", values)}},
                        .conversions = lammps_conversions(subject),
                        .check = {.code = "lammps", .tolerance = lammps_tolerance}},
                       values);
}

}  // namespace ashimpact
