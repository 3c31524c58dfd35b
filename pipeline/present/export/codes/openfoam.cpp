// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "pipeline/present/export/codes/tables.hpp"
#include "pipeline/present/export/expected.hpp"

namespace ashimpact {

namespace {

constexpr double flight = 1e-3;  // duration of the check; a parcel meets the wall in its middle [s]

template <class Values>
std::string foam_list(std::string_view name, const Values& values) {
    std::string text = fmt::format("{}\n(\n", name);
    for (const double value : values) text += "    " + exact(value) + "\n";
    return text + ");\n";
}

ExportFile foam_table(const ImpactTable& table, double density) {
    const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = table.restitution;
    const std::string text =
        fmt::format(
            "// Table of ashImpact: e over ln(diameter) and t = asinh(sqrt(v/startVelocity - 1)); SI units.\n"
            "density         {};\nnodes           {};\nstep            {};\nfromVelocity    {};\ntoVelocity  "
            "    {};\n"
            "captures        {};\n",
            exact(density), table.t.size(), exact(table.t[1]), exact(table.from_velocity),
            exact(table.to_velocity), table.captures ? "yes" : "no") +
        foam_list("diameter", table.diameter) + foam_list("startVelocity", table.start_velocity) +
        foam_list("slope", table.slope) + foam_list("restitution", rows.reshaped<Eigen::RowMajor>());
    return {"ashTable", text};
}

/// What libashimpact needs: the parameters by its names, and the damping by size and velocity.
ExportFile solver_file(const ExportSubject& subject) {
    std::string text = fmt::format(
        "// Model of ashImpact with `solver yes;`; SI units.\nlaw             {};\n"
        "detachment      {};\ndampingLaw      {};\nparameters\n{{\n",
        subject.law.name(), name_of(subject.detachment), name_of(subject.damping.law));
    const auto add = [&](std::string_view name, double value) {
        text += fmt::format("    {} {};\n", name, exact(value));
    };
    add("density", subject.density);
    add("contact_modulus", subject.contact.contact_modulus);
    add("work_of_adhesion", subject.contact.work_of_adhesion);
    if (std::isfinite(subject.contact.yield_pressure)) add("yield_pressure", subject.contact.yield_pressure);
    for (const LawParameter& parameter : subject.law.parameters())
        if (subject.contact.parameters.has(parameter))
            add(parameter.name, subject.contact.parameters[parameter]);
    std::vector<double> velocities;
    std::vector<double> coefficients;
    for (const DampingNode& node : subject.damping.nodes) {
        velocities.push_back(node.velocity);
        coefficients.push_back(node.coefficient);
    }
    text += fmt::format(
        "}}\n// coefficient(d, v) = c(v) (d/referenceDiameter)^exponent, c linear between these velocities\n"
        "referenceDiameter {};\nexponent        {};\n",
        exact(subject.damping.reference_diameter), exact(subject.damping.exponent));
    return {"ashSolver", text + foam_list("velocity", velocities) + foam_list("damping", coefficients)};
}

/// One injector a parcel, each with its own velocity, and the file of its place.
std::string injections(const std::vector<ExpectedImpact>& impacts, ExportFolder& folder) {
    std::string text;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        const double height = 0.5 * flight * impacts[i].velocity;
        text += fmt::format(
            "        impact{0}\n        {{\n            type            manualInjection;\n"
            "            massTotal       0;\n            parcelBasisType fixed;\n            nParticle       "
            "1;\n"
            "            SOI             0;\n            positionsFile   \"impact{0}\";\n"
            "            U0              (0 0 {1});\n"
            "            sizeDistribution {{ type fixedValue; fixedValueDistribution {{ value {2}; }} }}\n"
            "        }}\n",
            i, exact(-impacts[i].velocity), exact(impacts[i].diameter));
        folder.push_back(
            {fmt::format("check/constant/impact{}", i),
             fmt::format("FoamFile {{ version 2.0; format ascii; class vectorField; object impact{}; }}\n\n"
                         "((0.0037 0.0052 {}))\n",
                         i, exact(height))});
    }
    return text;
}

}  // namespace

ExportFolder openfoam_folder(const ExportSubject& subject) {
    require_wall(subject, "OpenFOAM: its parcels meet walls, and no second sphere");
    const ImpactTable table = make_impact_table(subject);
    ExportSubject within = subject;
    within.to_velocity = table.to_velocity;
    const auto impacts = expected_impacts(within);
    double fastest = 0;
    for (const ExpectedImpact& each : impacts) fastest = std::max(fastest, each.velocity);

    ExportFolder folder;
    TemplateValues values = common_values(subject);
    values["to_velocity"] = readable(table.to_velocity, "m/s");
    values["height"] = exact(flight * fastest);
    values["injections"] = injections(impacts, folder);
    const auto add = [&](std::string name, std::string_view path) {
        folder.push_back({std::move(name), filled(path, values)});
    };
    const auto copy = [&](std::string name, std::string_view path) {
        folder.push_back({std::move(name), unchanged(path).content});
    };
    add("README.md", "openfoam/README.md");
    copy("run.sh", "openfoam/run.sh");
    copy("compare.py", "openfoam/compare.py");
    for (const char* file : {"AshImpact.H", "AshImpact.C", "makeAshImpact.C", "build.sh"})
        copy(std::string("src/") + file, std::string("openfoam/src/") + file);
    copy("src/ash_table.h", "common/ash_table.h");
    copy("src/Make/files", "openfoam/src/Make_files");
    copy("src/Make/options", "openfoam/src/Make_options");
    for (const char* file : {"controlDict", "blockMeshDict", "fvSchemes", "fvSolution"})
        add(std::string("check/system/") + file, std::string("openfoam/check/") + file);
    for (const char* file : {"g", "transportProperties", "turbulenceProperties", "kinematicCloudProperties"})
        add(std::string("check/constant/") + file, std::string("openfoam/check/") + file);
    add("check/0/U", "openfoam/check/U");
    folder.push_back(foam_table(table, subject.density));
    folder.push_back({"check/constant/ashTable", folder.back().content});
    folder.push_back(solver_file(subject));
    folder.push_back({"check/constant/ashSolver", folder.back().content});
    folder.push_back(assumptions(
        subject,
        {"d is the parcel's diameter, v the velocity normal to the wall and relative to it, R* = d/2",
         "e and v_c from the table `ashTable`; the tangential velocity loses the share mu, 0 by default",
         "a parcel of nParticle particles sticks or rebounds as one; its mass counts nParticle times"}));
    folder.push_back(table_expected(subject, "openfoam", table));
    return folder;
}

}  // namespace ashimpact
