#include <fmt/format.h>

#include "materials/base/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/export/dem.hpp"

namespace ashimpact {

namespace {

constexpr double liggghts_tolerance = 1e-5;
constexpr auto liggghts_tried = "LIGGGHTS-PUBLIC 3.8.0 (Debian 12: liggghts)";

void require_liggghts(const ExportSubject& subject) {
    if (subject.law.name() == "jkr")
        throw InputError(
            "LIGGGHTS has no JKR: its `cohesion sjkr` is an energy density times an area, law sjkr",
            "hertz, dmt, brach-dunn, sjkr")
            .at("--law");
    if (const auto reason = added_forces_refusal(subject))
        throw InputError(
            "LIGGGHTS: " + *reason,
            "hertz, dmt, brach-dunn, sjkr with zero-overlap; damping constant, contact-radius, tsuji");
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

}  // namespace

ExportFolder liggghts_folder(const ExportSubject& subject) {
    require_liggghts(subject);
    TemplateValues values = dem_values(subject);
    values["code"] = "LIGGGHTS";
    values["command"] = "liggghts -in in.impacts -log log.impacts -screen none -echo none";
    values["tried"] = liggghts_tried;
    values["cloud_words"] = "";
    return {{"README.md", filled("common/README_dem.md", values)},
            {"ash_material.in", filled("liggghts/ash_material.in", values)},
            {"ash_wall.in", liggghts_wall_file(subject)},
            impact_variables(subject),
            {"in.impacts", filled("liggghts/in.impacts", values)},
            {"run.sh", filled("common/run_dem.sh", values)},
            unchanged("common/compare.py"),
            assumptions(subject, liggghts_conversions(subject)),
            dem_expected(subject, {.code = "liggghts", .tolerance = liggghts_tolerance})};
}

}  // namespace ashimpact
