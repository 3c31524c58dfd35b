// SPDX-License-Identifier: GPL-3.0-or-later
// Codes that look impacts up in a table: OpenFOAM, Fluent, and the table by itself.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/present/export/folder.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

/// |dv_t'| over the velocity that a table keeps between its nodes: that of e and of the attraction [1].
constexpr double tangential_accuracy = 2e-3;
constexpr double flight = 1e-3;  // duration of OpenFOAM's check; a parcel meets the wall in its middle [s]

/// Numbers, a line each, with what ends a number.
template <class Values>
std::string lines_of(const Values& values, std::string_view end) {
    std::string text;
    for (const double value : values) text.append("    ").append(exact(value)).append(end) += '\n';
    return text;
}

/// The restitutions in rows of one diameter.
Eigen::ArrayXd restitutions(const ImpactTable& table) {
    return table.restitution.reshaped<Eigen::RowMajor>();
}

Eigen::ArrayXd attractions_of(const ImpactTable& table) {
    return table.attraction.reshaped<Eigen::RowMajor>();
}

/// The subject with the velocities that its table has.
ExportSubject within(ExportSubject subject, const ImpactTable& table) {
    subject.to_velocity = table.to_velocity;
    return subject;
}

ExportFile table_expected(const ExportSubject& subject, std::string_view code, const ImpactTable& table) {
    return expected_json(within(subject, table), code,
                         {{"tolerance", table_accuracy},
                          {"tangential_tolerance", tangential_accuracy},
                          {"largest_error_found", table.largest_error}});
}

/// The least and the greatest density of the sizes [kg/m3].
std::array<double, 2> density_range(const ExportSubject& subject) {
    const auto [least, greatest] = std::ranges::minmax(subject.sizes, {}, &AshSize::density);
    return {least.density, greatest.density};
}

std::string fluent_header(const ExportSubject& subject, const ImpactTable& table) {
    const auto densities = density_range(subject);
    const auto array = [](std::string_view name, const auto& values) {
        return fmt::format("static const double {}[] = {{\n{}}};\n", name, lines_of(values, ","));
    };
    return fmt::format(
               "/* Table of ash_wall: e over ln(diameter) and t = asinh(sqrt(v/start_velocity - 1)); SI "
               "units. */\nstatic const double ash_least_density = {}, ash_greatest_density = {}; /* of the "
               "ash "
               "[kg/m3] */\n",
               exact(densities.front()), exact(densities.back())) +
           array("ash_diameters", table.diameter) + array("ash_start_velocities", table.start_velocity) +
           array("ash_slopes", table.slope) + array("ash_restitutions", restitutions(table)) +
           (table.attraction.size() > 0 ? array("ash_attractions", attractions_of(table)) : std::string()) +
           fmt::format("static const double ash_friction_coefficient = {};\n", exact(subject.friction)) +
           fmt::format(
               "static const AshTable ash_table = {{{}, {}, ash_diameters, ash_start_velocities, ash_slopes, "
               "ash_restitutions,\n    {}, {}, {}, {}, {}}};\n",
               table.diameter.size(), table.t.size(), table.attraction.size() > 0 ? "ash_attractions" : "0",
               exact(table.t[1]), exact(table.from_velocity), exact(table.to_velocity),
               table.captures ? 1 : 0);
}

template <class Values>
std::string foam_list(std::string_view name, const Values& values) {
    return fmt::format("{}\n(\n{});\n", name, lines_of(values, ""));
}

std::string foam_table(const ExportSubject& subject, const ImpactTable& table) {
    const auto densities = density_range(subject);
    return fmt::format(
               "// Table of ashImpact: e over ln(diameter) and t = asinh(sqrt(v/startVelocity - 1)); SI "
               "units.\ndensity         {};\n{}nodes           {};\nstep            {};\n"
               "fromVelocity    {};\ntoVelocity      {};\ncaptures        {};\n",
               exact(densities[0]),
               densities[0] == densities[1] ? "" : fmt::format("greatestDensity {};\n", exact(densities[1])),
               table.t.size(), exact(table.t[1]), exact(table.from_velocity), exact(table.to_velocity),
               table.captures ? "yes" : "no") +
           foam_list("diameter", table.diameter) + foam_list("startVelocity", table.start_velocity) +
           foam_list("slope", table.slope) + foam_list("restitution", restitutions(table)) +
           fmt::format("adhesive        {};\nfriction        {};\n", subject.law.is_adhesive() ? "yes" : "no",
                       exact(subject.friction)) +
           (table.attraction.size() > 0 ? foam_list("attraction", attractions_of(table)) : std::string());
}

/// A name with a list of numbers on one line.
template <class Values>
std::string foam_entry(std::string_view name, const Values& values) {
    std::string text = fmt::format("    {} (", name);
    for (const double value : values) text += " " + exact(value);
    return text + " );\n";
}

/// What libashimpact needs: for each known size the parameters by its names, and the nodes of the damping.
std::string foam_solver(const ExportSubject& subject) {
    std::string text = fmt::format(
        "// Model of ashImpact with `solver yes;`; SI units. Each list has a number for each diameter; "
        "between "
        "them the\n// parameters are linear in ln d, and so is ln(damping) at equal t. Beyond them damping "
        "goes "
        "with (d/d_0)^exponent.\nlaw             {};\ndetachment      {};\ndampingLaw      {};\n"
        "exponent        {};\nfriction        {};\n",
        subject.law.name(), name_of(subject.detachment), name_of(subject.damping_law),
        exact(subject.exponent), exact(subject.friction));
    const auto list = [&](std::string_view name, const auto& value_of) {
        std::vector<double> values;
        for (const AshSize& size : subject.sizes) values.push_back(value_of(size));
        text += foam_entry(name, values);
    };
    text += "known\n{\n";
    list("diameter", [](const AshSize& size) { return size.diameter; });
    text += "}\nparameters\n{\n";
    list("density", [](const AshSize& size) { return size.density; });
    list("contact_modulus", [](const AshSize& size) { return size.contact.contact_modulus; });
    list("work_of_adhesion", [](const AshSize& size) { return size.contact.work_of_adhesion; });
    if (std::isfinite(subject.reference().contact.yield_pressure))
        list("yield_pressure", [](const AshSize& size) { return size.contact.yield_pressure; });
    for (const LawParameter& parameter : parameters_of(subject.law, subject.damping_law))
        if (subject.reference().contact.parameters.has(parameter))
            list(parameter.name, [&](const AshSize& size) { return size.contact.parameters[parameter]; });
    text +=
        "}\n// damping(t) of each diameter, t = asinh(sqrt(v/v_c - 1))^2: linear between nodes, constant "
        "beyond\n";
    for (std::size_t i = 0; i < subject.sizes.size(); ++i) {
        std::vector<double> places;
        std::vector<double> coefficients;
        for (const DampingNode& node : subject.sizes[i].damping.nodes) {
            places.push_back(node.t * node.t);
            coefficients.push_back(node.coefficient);
        }
        text += fmt::format("curve{}\n{{\n{}{}}}\n", i, foam_entry("t", places),
                            foam_entry("damping", coefficients));
    }
    return text;
}

/// One injector a parcel, each with its own velocity, and the file of its place.
std::string injections(const std::vector<ExpectedImpact>& impacts, ExportFolder& folder) {
    std::string text;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        text += fmt::format(
            "        impact{0}\n        {{\n            type            manualInjection;\n"
            "            massTotal       0;\n            parcelBasisType fixed;\n            nParticle       "
            "1;\n"
            "            SOI             0;\n            positionsFile   \"impact{0}\";\n"
            "            U0              ({3} 0 {1});\n"
            "            sizeDistribution {{ type fixedValue; fixedValueDistribution {{ value {2}; }} }}\n"
            "        }}\n",
            i, exact(-impacts[i].velocity), exact(impacts[i].diameter),
            exact(impacts[i].tangential_velocity));
        folder.push_back(
            {fmt::format("check/constant/impact{}", i),
             fmt::format("FoamFile {{ version 2.0; format ascii; class vectorField; object impact{}; }}\n\n"
                         "((0.0037 0.0052 {}))\n",
                         i, exact(0.5 * flight * impacts[i].velocity))});
    }
    return text;
}

ExportFile critical_velocity_csv(const ImpactTable& table) {
    std::string csv = "diameter [m],critical_velocity [m/s],start_velocity [m/s],slope [1]\n";
    for (std::size_t i = 0; i < table.diameter.size(); ++i)
        csv += fmt::format("{},{},{},{}\n", exact(table.diameter[i]),
                           exact(table.captures ? table.start_velocity[i] : 0),
                           exact(table.start_velocity[i]), exact(table.slope[i]));
    return {"critical_velocity.csv", csv};
}

ExportFile table_csv(const ExportSubject& subject, const ImpactTable& table) {
    const bool rubs = subject.friction > 0;
    const bool attracts = table.attraction.size() > 0;
    std::string csv = fmt::format(
        "diameter [m],t [1],velocity [m/s],outcome,restitution [1],contact_time [s],damping [{}]{}\n",
        unit_of(subject.damping_law), rubs ? ",attraction [1]" : "");
    for (Eigen::Index i = 0; i < table.velocity.rows(); ++i)
        for (Eigen::Index j = 0; j < table.velocity.cols(); ++j) {
            const double time = table.contact_time(i, j);
            csv += fmt::format("{},{},{},{},{},{},{}{}\n", exact(table.diameter[static_cast<std::size_t>(i)]),
                               exact(table.t[static_cast<std::size_t>(j)]), exact(table.velocity(i, j)),
                               table.restitution(i, j) > 0 ? "rebound" : "capture",
                               exact(table.restitution(i, j)), std::isfinite(time) ? exact(time) : "",
                               exact(table.damping(i, j)),
                               rubs ? "," + exact(attracts ? table.attraction(i, j) : 0) : "");
        }
    return {"table.csv", csv};
}

}  // namespace

ExportFolder table_folder(const ExportSubject& subject, const TableImage& image) {
    require_inside_model(subject);
    const ImpactTable table = make_impact_table(subject);
    TemplateValues values = common_values(subject);
    values["sizes"] = std::to_string(table.diameter.size());
    values["nodes"] = std::to_string(table.t.size());
    values["from_velocity"] = readable(table.from_velocity, "m/s");
    values["to_velocity"] = readable(table.to_velocity, "m/s");
    values["from_velocity_exact"] = exact(table.from_velocity);
    values["to_velocity_exact"] = exact(table.to_velocity);
    values["captures"] = table.captures ? "True" : "False";
    values["along"] = subject.friction > 0 ? "`ash_table.oblique()` gives e_t and spin at an angle; "
                                             "\"attraction\": time integral of it over m v.\n"
                                           : "";
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

ExportFolder fluent_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    require_wall(subject, "Fluent: its particles meet walls, and no second sphere");
    require_inside_model(subject);
    const ImpactTable table = make_impact_table(subject);
    TemplateValues values = common_values(subject);
    values["to_velocity"] = readable(table.to_velocity, "m/s");
    return {
        {"README.md", filled("fluent/README.md", values)},
        unchanged("fluent/ash_wall.c"),
        unchanged("common/ash_table.h"),
        {"ash_table_data.h", fluent_header(subject, table)},
        {"stand_in/udf.h", unchanged("fluent/stand_in/udf.h").content},
        {"stand_in/check.c", unchanged("fluent/stand_in/check.c").content},
        unchanged("fluent/run.sh"),
        unchanged("fluent/compare.py"),
        assumptions(subject,
                    {"TP_DIAM is d, the velocity along the face normal is v, R* = d/2; the wall is at rest",
                     "TP_RHO must be the density above; ash_wall warns where it differs by more than 1 %",
                     "e and v_c from the table; along the wall a rigid sphere with friction " +
                         exact(subject.friction) + " and without spin before the impact slides or rolls"}),
        table_expected(subject, "fluent", table)};
}

ExportFolder openfoam_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    require_wall(subject, "OpenFOAM: its parcels meet walls, and no second sphere");
    require_inside_model(subject);
    const ImpactTable table = make_impact_table(subject);
    const auto impacts = expected_impacts(within(subject, table));
    double fastest = 0;
    double furthest = 0;
    for (const ExpectedImpact& each : impacts) {
        fastest = std::max(fastest, each.velocity);
        furthest = std::max(furthest, each.tangential_velocity);
    }

    ExportFolder folder;
    TemplateValues values = common_values(subject);
    values["to_velocity"] = readable(table.to_velocity, "m/s");
    values["height"] = exact(flight * fastest);
    values["width"] = exact(0.01 + 1.1 * flight * furthest);
    values["injections"] = injections(impacts, folder);
    const auto add = [&](const std::string& place, std::string_view path) {
        folder.push_back({place + unchanged(path).name, filled(path, values)});
    };
    const auto copy = [&](std::string name, std::string_view path) {
        folder.push_back({std::move(name), unchanged(path).content});
    };
    add("", "openfoam/README.md");
    copy("run.sh", "openfoam/run.sh");
    copy("compare.py", "openfoam/compare.py");
    for (const std::string file : {"AshImpact.H", "AshImpact.C", "makeAshImpact.C", "build.sh"})
        copy("src/" + file, "openfoam/src/" + file);
    copy("src/ash_table.h", "common/ash_table.h");
    copy("src/Make/files", "openfoam/src/Make_files");
    copy("src/Make/options", "openfoam/src/Make_options");
    for (const std::string file : {"controlDict", "blockMeshDict", "fvSchemes", "fvSolution"})
        add("check/system/", "openfoam/check/" + file);
    for (const std::string file :
         {"g", "transportProperties", "turbulenceProperties", "kinematicCloudProperties"})
        add("check/constant/", "openfoam/check/" + file);
    add("check/0/", "openfoam/check/U");
    for (const auto& [name, content] : {ExportFile{"ashTable", foam_table(subject, table)},
                                        ExportFile{"ashSolver", foam_solver(subject)}}) {
        folder.push_back({name, content});
        folder.push_back({"check/constant/" + name, content});
    }
    folder.push_back(assumptions(
        subject,
        {"d is the parcel's diameter, v the velocity normal to the wall and relative to it, R* = d/2",
         "e and v_c from the table `ashTable`; along the wall a rigid sphere with friction " +
             exact(subject.friction) +
             " slides or rolls, without spin before the impact unless the cloud has it",
         "a parcel of nParticle particles sticks or rebounds as one; its mass counts nParticle times"}));
    folder.push_back(table_expected(subject, "openfoam", table));
    return folder;
}

}  // namespace ashimpact
