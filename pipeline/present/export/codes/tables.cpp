// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/codes/tables.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/export/expected.hpp"

namespace ashimpact {

namespace {

/// Empty where there is no number.
std::string cell(double value) {
    return std::isfinite(value) ? exact(value) : std::string();
}

}  // namespace

ExportFile critical_velocity_csv(const ImpactTable& table) {
    std::string csv = "diameter [m],critical_velocity [m/s],start_velocity [m/s],slope [1]\n";
    for (std::size_t i = 0; i < table.diameter.size(); ++i)
        csv += fmt::format("{},{},{},{}\n", exact(table.diameter[i]),
                           exact(table.captures ? table.start_velocity[i] : 0),
                           exact(table.start_velocity[i]), exact(table.slope[i]));
    return {"critical_velocity.csv", csv};
}

ExportFile table_csv(const ExportSubject& subject, const ImpactTable& table) {
    std::string csv = fmt::format(
        "diameter [m],t [1],velocity [m/s],outcome,restitution [1],contact_time [s],damping [{}]\n",
        unit_of(subject.damping.law));
    for (Eigen::Index i = 0; i < table.velocity.rows(); ++i)
        for (Eigen::Index j = 0; j < table.velocity.cols(); ++j)
            csv += fmt::format("{},{},{},{},{},{},{}\n", exact(table.diameter[static_cast<std::size_t>(i)]),
                               exact(table.t[static_cast<std::size_t>(j)]), exact(table.velocity(i, j)),
                               table.restitution(i, j) > 0 ? "rebound" : "capture",
                               exact(table.restitution(i, j)), cell(table.contact_time(i, j)),
                               exact(table.damping(i, j)));
    return {"table.csv", csv};
}

ExportFile table_expected(const ExportSubject& subject, std::string_view code, const ImpactTable& table) {
    ExportSubject within = subject;
    within.to_velocity = table.to_velocity;
    return expected_json(within, code,
                         {{"tolerance", table_accuracy}, {"largest_error_found", table.largest_error}});
}

ExportFolder table_folder(const ExportSubject& subject, const TableImage& image) {
    const ImpactTable table = make_impact_table(subject);
    TemplateValues values = common_values(subject);
    values["sizes"] = std::to_string(table.diameter.size());
    values["nodes"] = std::to_string(table.t.size());
    values["from_velocity"] = readable(table.from_velocity, "m/s");
    values["to_velocity"] = readable(table.to_velocity, "m/s");
    values["from_velocity_exact"] = exact(table.from_velocity);
    values["to_velocity_exact"] = exact(table.to_velocity);
    values["captures"] = table.captures ? "True" : "False";
    values["error"] = fmt::format("{:.1g}", table.largest_error);
    return {{"README.md", filled("table/README.md", values)},
            critical_velocity_csv(table),
            table_csv(subject, table),
            {"table.h5", image(subject, table)},
            {"ash_table.py", filled("table/ash_table.py", values)},
            unchanged("table/compare.py"),
            assumptions(
                subject,
                {subject.partner ? "none: SI units, v_in and e of the relative velocity along the line of "
                                   "both centres at first touch"
                                 : "none: SI units, v_in and e normal to the wall at first touch, R* = d/2"}),
            table_expected(subject, "table", table)};
}

}  // namespace ashimpact
