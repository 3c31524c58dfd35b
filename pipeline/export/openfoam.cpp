#include <fmt/format.h>

#include <algorithm>

#include "pipeline/export/expected.hpp"
#include "pipeline/export/tables.hpp"
#include "pipeline/text/readable.hpp"

namespace ashimpact {

namespace {

constexpr double flight = 1e-3;  // duration of the check; a parcel meets the wall in its middle [s]

template <class Values>
std::string list(std::string_view name, const Values& values) {
    std::string text = fmt::format("{}\n(\n", name);
    for (const double value : values) text += "    " + exact(value) + "\n";
    return text + ");\n";
}

ExportFile table_file(const ImpactTable& table) {
    const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = table.restitution;
    const std::string text =
        fmt::format(
            "// Table of ashImpact: e over ln(diameter) and t = asinh(sqrt(v/startVelocity - 1)); SI units.\n"
            "nodes           {};\nstep            {};\nfromVelocity    {};\ntoVelocity      {};\n"
            "captures        {};\n",
            table.t.size(), exact(table.t[1]), exact(table.from_velocity), exact(table.to_velocity),
            table.captures ? "yes" : "no") +
        list("diameter", table.diameter) + list("startVelocity", table.start_velocity) +
        list("slope", table.slope) + list("restitution", rows.reshaped<Eigen::RowMajor>());
    return {"ashTable", text};
}

/// What libashimpact needs; only damping that is the same for every size and velocity has one number.
ExportFile solver_file(const ExportSubject& subject) {
    return {"ashSolver",
            fmt::format("// Model of ashImpact with `solver yes;`; SI units.\nlaw             {};\n"
                        "detachment      {};\ndampingLaw      {};\ndensity         {};\n"
                        "contactModulus  {};\nworkOfAdhesion  {};\ndamping         {};\n",
                        subject.law.name(), name_of(subject.detachment), name_of(subject.damping.law),
                        exact(subject.density), exact(subject.contact.contact_modulus),
                        exact(subject.contact.work_of_adhesion),
                        exact(subject.damping.nodes.front().coefficient))};
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
    folder.push_back(table_file(table));
    folder.push_back({"check/constant/ashTable", folder.back().content});
    if (!subject.damping.depends_on_velocity() && subject.damping.exponent == 0) {
        folder.push_back(solver_file(subject));
        folder.push_back({"check/constant/ashSolver", folder.back().content});
    }
    folder.push_back(assumptions(
        subject,
        {"d is the parcel's diameter, v the velocity normal to the wall and relative to it, R* = d/2",
         "e and v_c from the table `ashTable`; the tangential velocity loses the share mu, 0 by default",
         "a parcel of nParticle particles sticks or rebounds as one; its mass counts nParticle times"}));
    folder.push_back(table_expected(subject, "openfoam", table));
    return folder;
}

}  // namespace ashimpact
