// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "pipeline/app/cli/argument_checks.hpp"
#include "pipeline/app/cli/commands.hpp"
#include "pipeline/app/commands/calibration/calibrate.hpp"
#include "pipeline/app/commands/calibration/cross_check.hpp"
#include "pipeline/app/commands/documents.hpp"
#include "pipeline/app/commands/materials/modulus.hpp"
#include "pipeline/app/commands/materials/phases.hpp"
#include "pipeline/app/commands/run.hpp"

namespace ashimpact {

namespace {

void add_allow_outside(CLI::App& command, bool& allow_outside) {
    command.add_flag("--allow-outside", allow_outside, "the case may name files outside of its own folder");
}

void add_run(CLI::App& program, Action& action) {
    auto* command =
        add_command(program, "run", "Every stage of a case, from XRD to the critical velocity",
                    "ashimpact run my-case/case.json -o my-case/results\n"
                    "  ashimpact run -o my-case/results --from fit    # after editing an artifact there");
    const auto options = std::make_shared<RunOptions>();
    command->add_option("case", options->case_file, "case file; default: the built-in case, Dong et al. 2013")
        ->type_name("CASE.json");
    command->add_option("-o,--output", options->folder, "folder of the artifacts")
        ->capture_default_str()
        ->type_name("DIR");
    auto* from =
        command
            ->add_option("--from", options->from,
                         "start at this stage, from the artifacts in the folder: modulus, contact, analytic, "
                         "restitution, damping, fit, critical-velocity, histories, comparison")
            ->type_name("STAGE");
    command->add_option("--only", options->only, "run this stage alone")->type_name("STAGE")->excludes(from);
    command->add_flag("--no-report", options->no_report, "leave report.html out");
    command->add_flag("--figures", options->figures,
                      "every figure as SVG and PDF too, for one column and for two (PDF: librsvg2-bin)");
    add_allow_outside(*command, options->allow_outside);
    command->callback(
        [options, &action] { action = [options](std::ostream& out) { run_run_command(*options, out); }; });
}

void add_modulus(CLI::App& program, Action& action) {
    auto* command =
        add_command(program, "modulus", "XRD result -> phase volumes -> Young's modulus with bounds",
                    "ashimpact modulus my-case/ash.csv --amorphous-fraction '42 +- 2 %'\n"
                    "  (ash.csv is among what `ashimpact init my-case` writes)");
    const auto options = std::make_shared<ModulusCommandOptions>();
    command
        ->add_option(
            "file", options->file,
            "XRD result: BGMN/Profex or GSAS-II .lst, FullProf .sum, TOPAS .out, CSV, .xlsx, .ods or JSON")
        ->required()
        ->type_name("FILE");
    const auto add = [&](const char* name, std::string& value, const char* type, const char* purpose) {
        return command->add_option(name, value, purpose)->type_name(type);
    };
    add("--amorphous-fraction", options->amorphous_fraction, "X",
        "amorphous part of the whole, by weight (by volume where the file is); none; remainder: what is "
        "missing to 100 %");
    add("--crystalline-total", options->crystalline_total, "X", "the rest of the whole is amorphous");
    add("--internal-standard", options->internal_standard, "PHASE",
        "standard that was added and refined; the amorphous part follows");
    add("--added-fraction", options->added_fraction, "X", "its weight over that of the mixture");
    add("--sample", options->sample, "NAME", "of a file with several; default: all");
    add("--sheet", options->sheet, "NAME", "of a spreadsheet with several tables");
    add("--phase-set", options->phase_set, "NAME", "phase set to look in first: literature, dong2013");
    add("--phases", options->phases, "CASE.json", "case file whose own phases come before all others");
    add("--rule", options->rule, "NAME", "mixture rule of the modulus")->capture_default_str();
    add("--porosity-law", options->porosity_law, "NAME", "law by which pores soften; default: no pores");
    add("--porosity", options->porosity, "X", "default: from --particle-density and the phases");
    add("--porosity-coefficient", options->porosity_coefficient, "B", "b of the law spriggs");
    add("--particle-density", options->particle_density, "RHO", "as measured, pores included");
    command->add_flag("--json", options->json, "print one JSON object, numbers with 17 significant digits");
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_modulus_command(*options, out); };
    });
}

void add_calibrate(CLI::App& program, Action& action) {
    auto* command =
        add_command(program, "calibrate",
                    "Unknown constants of a case, from published critical velocities and contact times",
                    "ashimpact calibrate --free density:each --free work_of_adhesion");
    const auto options = std::make_shared<CalibrateOptions>();
    command->add_option("case", options->case_file, "case file; default: the built-in case, Dong et al. 2013")
        ->type_name("CASE.json");
    command
        ->add_option(
            "--free", options->free,
            "a constant to find: density, work_of_adhesion, contact_modulus, wall_young_modulus; with :each "
            "one value a sample; default: what the case says")
        ->type_name("NAME[:each]")
        ->allow_extra_args(false);
    command
        ->add_flag("--compare", options->compare,
                   "hypotheses beside one another: one modulus or those from XRD, one density or one a size, "
                   "wall known or free")
        ->excludes("--free");
    add_allow_outside(*command, options->allow_outside);
    command->add_flag("--json", options->json, "print one JSON object, numbers with 17 significant digits");
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_calibrate_command(*options, out); };
    });
}

void add_cross_check(CLI::App& program, Action& action) {
    auto* command = add_command(program, "cross-check",
                                "Whether published damping fits of several laws describe the same impacts",
                                "ashimpact cross-check");
    const auto options = std::make_shared<CrossCheckOptions>();
    command->add_option("case", options->case_file, "case file; default: the built-in case, Dong et al. 2013")
        ->type_name("CASE.json");
    add_allow_outside(*command, options->allow_outside);
    command->add_flag("--json", options->json, "print one JSON object, numbers with 17 significant digits");
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_cross_check_command(*options, out); };
    });
}

void add_inspect(CLI::App& program, Action& action) {
    auto* command = add_command(program, "inspect", "An artifact as tables; -v: inputs and options too",
                                "ashimpact inspect results/comparison.json");
    const auto options = std::make_shared<InspectOptions>();
    command->add_option("artifact", options->file, "file of a run's folder")
        ->required()
        ->type_name("ARTIFACT.json");
    command->add_flag("--all", options->all, "every row and every part, nothing shortened");
    command->callback([options, &action] {
        action = [options](std::ostream& out) { run_inspect_command(*options, out); };
    });
}

/// A command with one argument.
void add_document_command(CLI::App* command, Action& action, const char* name, const char* type,
                          const char* purpose, bool required,
                          void (*run)(const std::string&, std::ostream&)) {
    const auto argument = std::make_shared<std::string>();
    command->add_option(name, *argument, purpose)->type_name(type)->required(required);
    command->callback(
        [argument, &action, run] { action = [argument, run](std::ostream& out) { run(*argument, out); }; });
}

}  // namespace

void add_case_commands(CLI::App& program, Action& action) {
    add_run(program, action);
    add_modulus(program, action);
}

void add_document_commands(CLI::App& program, Action& action) {
    add_calibrate(program, action);
    add_cross_check(program, action);
    add_inspect(program, action);
    add_document_command(
        add_command(program, "init", "Write a commented case to start from", "ashimpact init my-case"),
        action, "folder", "DIR", "where to write it", true, run_init_command);
    add_document_command(add_command(program, "phases", "The phase catalogue, or one phase with its sources",
                                     "ashimpact phases mullite"),
                         action, "name", "NAME", "of a phase, under any of its names; without it, all phases",
                         false, run_phases_command);
    add_document_command(
        add_command(program, "schema", "The JSON Schema of a case or an artifact", "ashimpact schema case"),
        action, "name", "NAME", "of the schema; without it, the names", false, run_schema_command);
}

}  // namespace ashimpact
