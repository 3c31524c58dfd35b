#include <fmt/format.h>

#include "materials/base/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/export/dem.hpp"

namespace ashimpact {

namespace {

constexpr double lammps_tolerance = 1e-6;
constexpr auto lammps_tried = "LAMMPS of 2022-01-06 (Debian 12: lammps), package GRANULAR";

/// What this version's `fix wall/gran granular` does itself; the rest goes through added_forces().
struct OwnForces {
    bool attraction;
    bool damping;
};

OwnForces own_forces(const ExportSubject& subject) {
    const SizedDamping& damping = subject.damping;
    return {.attraction = subject.law.name() == "dmt",
            .damping = damping.law == DampingLaw::constant && !damping.depends_on_velocity() &&
                       damping.exponent == 0};
}

void require_lammps(const ExportSubject& subject) {
    if (subject.law.name() == "jkr")
        throw InputError("LAMMPS of Debian 12 gives NaN for JKR on a wall past pull-off",
                         "hertz, dmt, brach-dunn, sjkr")
            .at("--law");
    if (const auto reason = added_forces_refusal(subject))
        throw InputError(
            "LAMMPS: " + *reason,
            "hertz, dmt, brach-dunn, sjkr with zero-overlap; damping constant, contact-radius, tsuji");
}

std::string wall(const ExportSubject& subject, const OwnForces& own) {
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
    const OwnForces own = own_forces(subject);
    const bool attraction = attracts(subject) && !own.attraction;
    const bool damping = !own.damping && !subject.damping.is_zero();
    return fmt::format(
               "# Ash on the wall z = ash_wall_z: law {}, contact ends at zero overlap. Needs the variable "
               "ash_wall_z.\n# `damping velocity` must stand there: the default, viscoelastic, is another "
               "law. E = 2 E* and nu = 0: the\n# effective modulus of a wall is E/(2(1 - nu)) in this "
               "version. "
               "Its surface energy is w/2.\n",
               subject.law.name()) +
           wall(subject, own) + added_forces(subject, attraction, damping);
}

std::vector<std::string> lammps_conversions(const ExportSubject& subject) {
    const OwnForces own = own_forces(subject);
    std::vector<std::string> lines{
        own.attraction
            ? "`dmt`: E = 2 E* with nu = 0, since its wall takes E/(2(1 - nu)) as effective modulus; "
              "surface energy gamma = w/2"
            : "`hertz`: K_n = (4/3) E*",
        "R* is the radius of the sphere: the wall is flat"};
    if (own.damping && !subject.damping.is_zero())
        lines.emplace_back("`damping velocity` with eta in kg/s: F_d = -eta v, as here");
    const auto added = added_force_conversions(subject, attracts(subject) && !own.attraction,
                                               !own.damping && !subject.damping.is_zero());
    lines.insert(lines.end(), added.begin(), added.end());
    return lines;
}

}  // namespace

ExportFolder lammps_folder(const ExportSubject& subject) {
    require_lammps(subject);
    TemplateValues values = dem_values(subject);
    values["code"] = "LAMMPS";
    values["command"] = "lmp -in in.impacts -log log.impacts -screen none -nocite";
    values["tried"] = lammps_tried;
    values["cloud_words"] = "`in.cloud` throws many sizes at that wall. ";
    return {{"README.md", filled("common/README_dem.md", values)},
            {"ash_wall.in", lammps_wall_file(subject)},
            impact_variables(subject),
            {"in.impacts", filled("lammps/in.impacts", values)},
            {"in.cloud", filled("lammps/in.cloud", values)},
            {"run.sh", filled("common/run_dem.sh", values)},
            unchanged("common/compare.py"),
            assumptions(subject, lammps_conversions(subject)),
            dem_expected(subject, {.code = "lammps", .tolerance = lammps_tolerance})};
}

}  // namespace ashimpact
