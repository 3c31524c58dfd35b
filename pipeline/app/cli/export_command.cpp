// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "core/text.hpp"
#include "pipeline/app/cli/argument_checks.hpp"
#include "pipeline/app/cli/commands.hpp"
#include "pipeline/present/export/codes/codes.hpp"

namespace ashimpact {

namespace {

void add_subject_options(CLI::App& command, ExportOptions& options) {
    const auto add = [&](const char* name, std::string& value, const char* type, const char* purpose) {
        return command.add_option(name, value, purpose)->type_name(type);
    };
    add("--sample", options.sample, "NAME", "of the run");
    command.add_flag("--follow-velocity", options.follow_velocity,
                     "of a run: damping along the measured e(v_in) instead of the critical one");
    add_contact_options(command, options.contact, ContactNeeds::optional);
    add_damping_option(command, options.contact);
    add("--velocity", options.velocity, "Q", "one more impact to check");
    add("--from-diameter", options.from_diameter, "Q",
        "smallest size; default: that of the sphere or sample");
    add("--to-diameter", options.to_diameter, "Q", "largest size; default: that of the sphere or sample");
    add("--to-velocity", options.to_velocity, "Q", "largest velocity; default: 10 v_c, at least 10 m/s");
    add("--damping-exponent", options.damping_exponent, "N",
        "for several sizes: damping goes with (diameter/that of the sphere)^N; 0: the same for all");
}

}  // namespace

void add_export_command(CLI::App& program, Action& action, const ExportRunner& runner) {
    auto* command = add_command(
        program, "export", "Runnable inputs for DEM and CFD codes",
        "ashimpact export lammps results --sample \"88 um\" --law brach-dunn -o ash-in-lammps\n"
        "  ashimpact export openfoam --law dmt --radius \"5 um\" --density \"2300 kg/m3\" --contact-modulus "
        "\"60 GPa\"\n    --work-of-adhesion \"0.2 J/m2\" --damping \"1e-5 kg/s\" --from-diameter \"1 um\" "
        "--to-diameter "
        "\"50 um\"\n    --damping-exponent 2 -o ash-in-openfoam\n"
        "The folder holds inputs, a README, the assumptions, expected.json and a script that compares.");
    const auto options = std::make_shared<ExportOptions>();
    std::vector<std::string> codes;
    for (const ExportCode& code : export_codes()) codes.emplace_back(code.name);
    command->add_option("code", options->code, joined(codes))->required()->type_name("CODE");
    command->add_option("run", options->run, "folder of a run; else give the options of an impact")
        ->type_name("RUN_DIR");
    add_subject_options(*command, *options);
    command->add_option("-o,--output", options->folder, "folder to write")->required()->type_name("DIR");
    command->callback([options, runner, &action] {
        action = [options, runner](std::ostream& out) { runner(*options, out); };
    });
}

}  // namespace ashimpact
