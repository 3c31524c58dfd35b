// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

namespace {

/// The remarks on the results: those on implausible values first; the others whole with -v, else a line for
/// each kind that may change what to report.
void tell(RunSummary summary) {
    std::erase_if(summary.remarks, [](const Remark& remark) {
        if (remark.note.code != implausible_code) return false;
        spdlog::warn("warning: {}: {}", remark.file, text_of(remark.note));
        return true;
    });
    if (spdlog::should_log(spdlog::level::debug)) {
        for (const Remark& remark : summary.remarks)
            spdlog::debug("warning: {}: {}", remark.file, text_of(remark.note));
        return;
    }
    if (summary.remarks.empty()) return;
    const auto lines = remark_lines(summary.remarks, summary.samples);
    const auto deciding = std::ranges::count(lines, true, &RemarkLine::decides);
    const bool all = static_cast<std::size_t>(deciding) == lines.size();
    spdlog::warn("warning: {} on these results, {}; {}-v shows each of them whole",
                 counted(summary.remarks.size(), "remark"), counted(lines.size(), "kind"),
                 all             ? ""
                 : deciding == 0 ? "none of them changes what to report, "
                                 : fmt::format("{} of them may change what to report, ", deciding));
    for (const RemarkLine& line : lines)
        if (line.decides) spdlog::warn("  {}", line.text);
}

/// The temperature of the command line, which a run from artifacts cannot take.
std::optional<Stated> stated_temperature(const CommandOptions& options) {
    if (!options.has("--temperature")) return std::nullopt;
    return at_place("--temperature", [&] {
        if (options.has("--from") || options.has("--only"))
            throw InputError("is part of the case", "a run of every stage, without --from and --only");
        Stated stated{.quantity = quantity_of_text(options["--temperature"], Dimension::temperature),
                      .source = "--temperature"};
        require_positive("temperature", stated.value(), Dimension::temperature);
        require_certain(stated.quantity.standard_uncertainty, in_quotes(options["--temperature"]) + " ",
                        "the temperature alone");
        return std::optional(stated);
    });
}

void run_run_command(const CommandOptions& options, std::ostream& out) {
    StepLine line(on_terminal() && !spdlog::should_log(spdlog::level::debug));
    const RunPlan plan{.case_file = options.if_given("case"),
                       .folder = options["--output"],
                       .from = options["--from"],
                       .only = options["--only"],
                       .report = !options.has("--no-report"),
                       .figures = options.has("--figures"),
                       .allow_outside = options.has("--allow-outside"),
                       .temperature = stated_temperature(options),
                       .on_step = [&](const std::string& step) { line.show(step); }};
    const RunSummary summary = run_stages(plan);
    line.clear();
    tell(summary);
    print_readings(summary.files);
    for (const Artifact& artifact : summary.written)
        if (artifact.file == comparison_artifact)
            out << comparison_text(artifact.document->at("result"), output_width(), summary.scope) << '\n';
    out << summary.inputs;
    const auto answer = std::ranges::find(summary.written, critical_velocity_artifact, &Artifact::file);
    const Artifact& shown = answer == summary.written.end() ? summary.written.front() : *answer;
    out << fmt::format("{} artifacts in {}. One of them as tables:\n  {} inspect {}\n",
                       summary.written.size(), plan.folder.string(), program_word(),
                       shell_word((plan.folder / shown.file).string()));
    if (summary.figures > 0)
        out << fmt::format("{} files of figures in {}.\n", summary.figures,
                           (plan.folder / "figures").string());
    if (!summary.report.empty()) out << fmt::format("Report: {}\n", summary.report.string());
}

}  // namespace

void add_run(const CommandLine& line) {
    Command command =
        line.add("run", "Every stage of a case, from XRD to the critical velocity",
                 "ashimpact run my-case/case.json -o my-case/results\n"
                 "  ashimpact run -o my-case/results --from fit    # after editing an artifact there",
                 run_run_command);
    command.add_case_argument();
    command.add("-o,--output", "DIR", "folder of the artifacts", "results");
    auto* from = command.add("--from", "STAGE",
                             "start at this stage, from the artifacts in the folder: modulus, contact, "
                             "analytic, restitution, damping, fit, critical-velocity, histories, comparison");
    command.add("--only", "STAGE", "run this stage alone")->excludes(from);
    command.add(
        "--temperature", "Q",
        "of particle and wall, instead of those of the case: up to which temperature the answer holds");
    command.add_flag("--no-report", "leave report.html out");
    command.add_flag("--figures",
                     "every figure as SVG and PDF too, for one column and for two (PDF: librsvg2-bin)");
    command.add_allow_outside_flag();
}

void add_sweep(const CommandLine& line, const CommandBody& body) {
    Command command =
        line.add("sweep", "Many impacts: grids, Monte Carlo, sensitivity; also under mpirun",
                 "ashimpact sweep spec.json -o sweep.json\n"
                 "  mpirun -n 4 ashimpact sweep spec.json -o sweep.json\n"
                 "A spec, such as (`ashimpact schema sweep` and docs/sweep.md say all):\n"
                 "  {\n"
                 "    \"impact\": {\"laws\": [\"dmt\", \"jkr\"], \"density\": \"2600 kg/m3\",\n"
                 "               \"contact_modulus\": \"90 GPa\", \"damping\": \"0.0141 kg/s\",\n"
                 "               \"work_of_adhesion\": \"0.3 J/m2\"},\n"
                 "    \"variables\": {\n"
                 "      \"velocity\": {\"distribution\": \"uniform\",\n"
                 "                   \"from\": \"0.5 m/s\", \"to\": \"5 m/s\"},\n"
                 "      \"radius\": {\"distribution\": \"log-normal\", \"median\": \"44 um\",\n"
                 "                 \"geometric_standard_deviation\": 1.5}},\n"
                 "    \"sampling\": {\"method\": \"quasi-random\", \"samples\": 65536, \"seed\": 1},\n"
                 "    \"sensitivity\": [\"restitution\"]\n"
                 "  }\n"
                 "The result is the same for any number of processes and threads. A sweep that was stopped "
                 "goes on from its\ncheckpoint, beside the result, when the same command runs again.",
                 body);
    command.add("spec", "SPEC.json", "JSON file that defines the sweep")->required();
    command.add("-o,--output", "FILE", "JSON file for the result; a full table goes beside it (.h5)")
        ->required();
    command.add("--threads", "INT", "of each process; 0: its share of the cores", "0")
        ->check(whole_number(0, 1024));
    command.add("--checkpoint", "SECONDS", "seconds between checkpoints", "10")->check(number_within(0, 1e6));
    command.add_flag("--restart", "begin anew though there is a checkpoint");
    command.add_flag("--no-report", "leave out the report, which stands beside the result (.html)");
    command.add_flag("--progress", "show progress though standard error is no terminal");
}

}  // namespace ashimpact
