// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/artifact_text.hpp"

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "pipeline/present/text/comparison_table.hpp"

namespace ashimpact {

namespace {

std::string provenance_text(const Json& artifact, std::size_t width) {
    const Json& provenance = artifact.at("provenance");
    std::string text;
    for (const Json& input : provenance.at("inputs"))
        text += fmt::format("from {}\n  sha256 {}\n", input.at("file").get<std::string>(),
                            input.at("sha256").get<std::string>());
    if (!provenance.at("options").empty())
        text += "options\n" + result_text(provenance.at("options"), {.all = true, .width = width});
    for (const Json& citation : artifact.at("citations"))
        text += wrapped("cites " + citation.get<std::string>(), width, 2) + "\n";
    return text;
}

}  // namespace

std::string artifact_text(const Json& artifact, const ArtifactView& view) {
    const std::size_t width = view.result.width;
    const Json& provenance = artifact.at("provenance");
    std::string text =
        fmt::format("{} by {} {} ({})\n\n", artifact.at("schema").get<std::string>(),
                    provenance.at("program").get<std::string>(), provenance.at("version").get<std::string>(),
                    provenance.at("revision").get<std::string>());
    const bool is_comparison = artifact.at("stage") == "comparison";
    if (is_comparison) text += comparison_text(artifact.at("result"), width);
    std::string result;
    if (!is_comparison || view.result.all) result = result_text(artifact.at("result"), view.result);
    text += (is_comparison && !result.empty() ? "\n" : "") + result;
    if (const std::string legend = uncertainty_legend(text); !legend.empty()) text += "\n" + legend;
    if (!artifact.at("warnings").empty()) text += "\n";
    for (const Json& warning : artifact.at("warnings"))
        text += wrapped("warning: " + warning.get<std::string>(), width, 2) + "\n";
    if (view.provenance) return text + "\n" + provenance_text(artifact, width);
    return text + "\nInputs, options and citations: -v." +
           (is_comparison && !view.result.all ? " Everything else it holds: --all." : "") + "\n";
}

}  // namespace ashimpact
