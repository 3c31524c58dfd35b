// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>

#include "pipeline/app/cli/commands.hpp"
#include "pipeline/app/commands/report.hpp"

namespace ashimpact {

namespace {

void add_report(CLI::App& program, Action& action) {
    auto* command =
        add_command(program, "report", "The report of a run as one HTML file, or of several side by side",
                    "ashimpact report results\n"
                    "  ashimpact report sweep.json\n"
                    "  ashimpact report before after -o comparison.html");
    const auto options = std::make_shared<ReportOptions>();
    command->add_option("runs", options->runs, "folders of finished runs, or the result of one sweep")
        ->required()
        ->type_name("DIR");
    command
        ->add_option(
            "-o,--output", options->output,
            "HTML file; default: report.html in the one folder, or the name of the result with .html")
        ->type_name("FILE.html");
    command->callback(
        [options, &action] { action = [options](std::ostream& out) { run_report_command(*options, out); }; });
}

void add_figure(CLI::App& program, Action& action) {
    auto* command =
        add_command(program, "figure", "One figure of a run for a paper: SVG, PDF or PNG",
                    "ashimpact figure restitution results -o restitution.pdf\n"
                    "Figures: composition, static-force, regime-map, restitution, damping, damping-fit, "
                    "contact-time, sizes, histories,\n"
                    "energy, critical-velocity, sensitivity.");
    const auto options = std::make_shared<FigureOptions>();
    command->add_option("name", options->name, "of the figure")->required()->type_name("NAME");
    command
        ->add_option("artifacts", options->artifacts,
                     "folder of a run, or artifacts of it; those not named are read beside the first")
        ->required()
        ->type_name("ARTIFACT");
    command
        ->add_option("-o,--output", options->output, "file; its ending says the format: .svg, .pdf or .png")
        ->required()
        ->type_name("FILE");
    command->add_option("--width", options->width, "column of a journal: single (85 mm), double (170 mm)")
        ->capture_default_str()
        ->check(CLI::IsMember({"single", "double"}))
        ->type_name("WIDTH");
    command->callback(
        [options, &action] { action = [options](std::ostream& out) { run_figure_command(*options, out); }; });
}

}  // namespace

void add_report_commands(CLI::App& program, Action& action) {
    add_report(program, action);
    add_figure(program, action);
}

}  // namespace ashimpact
