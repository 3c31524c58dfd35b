// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "pipeline/present/export/codes/tables.hpp"

namespace ashimpact {

namespace {

template <class Values>
std::string c_array(std::string_view name, const Values& values) {
    std::string text = fmt::format("static const double {}[] = {{\n", name);
    for (const double value : values) text += "    " + exact(value) + ",\n";
    return text + "};\n";
}

std::string table_header(const ExportSubject& subject, const ImpactTable& table) {
    const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = table.restitution;
    return "/* Table of ash_wall: e over ln(diameter) and t = asinh(sqrt(v/start_velocity - 1)); SI units. "
           "*/\n" +
           fmt::format("static const double ash_density = {}; /* of the ash [kg/m3] */\n",
                       exact(subject.density)) +
           c_array("ash_diameters", table.diameter) + c_array("ash_start_velocities", table.start_velocity) +
           c_array("ash_slopes", table.slope) +
           c_array("ash_restitutions", rows.reshaped<Eigen::RowMajor>()) +
           fmt::format(
               "static const AshTable ash_table = {{{}, {}, ash_diameters, ash_start_velocities, ash_slopes, "
               "ash_restitutions,\n    {}, {}, {}, {}}};\n",
               table.diameter.size(), table.t.size(), exact(table.t[1]), exact(table.from_velocity),
               exact(table.to_velocity), table.captures ? 1 : 0);
}

}  // namespace

ExportFolder fluent_folder(const ExportSubject& subject) {
    require_wall(subject, "Fluent: its particles meet walls, and no second sphere");
    const ImpactTable table = make_impact_table(subject);
    TemplateValues values = common_values(subject);
    values["to_velocity"] = readable(table.to_velocity, "m/s");
    return {
        {"README.md", filled("fluent/README.md", values)},
        unchanged("fluent/ash_wall.c"),
        unchanged("common/ash_table.h"),
        {"ash_table_data.h", table_header(subject, table)},
        {"stand_in/udf.h", unchanged("fluent/stand_in/udf.h").content},
        {"stand_in/check.c", unchanged("fluent/stand_in/check.c").content},
        unchanged("fluent/run.sh"),
        unchanged("fluent/compare.py"),
        assumptions(
            subject,
            {"TP_DIAM is d, the velocity along the face normal is v, R* = d/2; the wall is at rest",
             "TP_RHO must be the density above; ash_wall warns where it differs by more than 1 %",
             "e and v_c from the table; the tangential velocity loses ASH_TANGENTIAL_LOSS, 0 by default"}),
        table_expected(subject, "fluent", table)};
}

}  // namespace ashimpact
