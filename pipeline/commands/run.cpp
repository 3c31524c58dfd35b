#include "pipeline/commands/run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <ostream>

#include "materials/base/text.hpp"
#include "pipeline/run.hpp"
#include "pipeline/text/comparison_table.hpp"

namespace ashimpact {

void run_run_command(const RunOptions& options, std::ostream& out) {
    RunPlan plan{.case_file = std::nullopt,
                 .folder = options.folder,
                 .from = options.from,
                 .only = options.only,
                 .report = !options.no_report,
                 .figures = options.figures,
                 .allow_outside = options.allow_outside};
    if (!options.case_file.empty()) plan.case_file = options.case_file;
    const RunSummary summary = run_stages(plan);
    for (const std::string& warning : summary.warnings) spdlog::debug("warning: {}", warning);
    if (!summary.warnings.empty() && !spdlog::should_log(spdlog::level::debug))
        spdlog::warn(
            "warning: {} remarks on these results are in the artifacts under \"warnings\"; -v shows them",
            summary.warnings.size());
    for (const Artifact& artifact : summary.written)
        if (artifact.file == comparison_artifact)
            out << comparison_text(View(artifact.document).at("result")) << '\n';
    out << fmt::format("{} artifacts in {}; `ashimpact inspect {}` shows one.\n", summary.written.size(),
                       plan.folder.string(),
                       shell_word((plan.folder / summary.written.front().file).string()));
    if (summary.figures > 0)
        out << fmt::format("{} files of figures in {}.\n", summary.figures,
                           (plan.folder / "figures").string());
    if (!summary.report.empty()) out << fmt::format("Report: {}\n", summary.report.string());
}

}  // namespace ashimpact
