// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/files/file.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact::report {

/// The report of one run, or of several side by side, as one self-contained HTML file. The same runs give
/// the same bytes.
[[nodiscard]] std::string run_page(const std::vector<RunData>& runs);

/// The answer of a run, a sentence for each sample, and the table of critical velocities.
[[nodiscard]] std::string answers_html(const RunData& run);
[[nodiscard]] std::string comparison_html(const RunData& run);

/// What was assumed, inferred or reconstructed; what the model holds for; warnings, grouped.
[[nodiscard]] std::string assumptions_html(const RunData& run);
[[nodiscard]] std::string validity_html(const RunData& run);
[[nodiscard]] std::string warnings_html(const RunData& run);

/// Program, inputs and artifacts with their hashes, citations.
[[nodiscard]] std::string provenance_html(const RunData& run);

/// The label of a part of a run's page, escaped; with the label of the run if the page shows several.
[[nodiscard]] std::string region_label(const std::string& label, const RunData& run);

/// File of a run's report, and the folder of its figures.
inline constexpr std::string_view report_file = "report.html";
inline constexpr std::string_view figures_folder = "figures";

/// The artifacts that a report and its figures are made of.
[[nodiscard]] const std::vector<std::string_view>& report_artifacts();

/// What to make of a run.
struct PresentationPlan {
    std::filesystem::path folder;  ///< into which it will be written
    bool page = true;              ///< the report
    bool figures = false;          ///< each figure as SVG and PDF, for one column and for two
};

struct Presentation {
    std::filesystem::path page{};  ///< of the report; empty: none
    std::vector<FileContent> files{};
};

/// Report and figures of one run, nothing written. The same run gives the same bytes.
/// @throws InputError if the program that makes PDF files is missing
[[nodiscard]] Presentation present(Run run, const PresentationPlan& plan);

/// The files that an earlier run with --figures left in the folder @p figures, known by their names and by
/// the mark in the SVG of each pair.
[[nodiscard]] std::vector<std::filesystem::path> own_figures(const std::filesystem::path& figures);

/// Refuses to begin where figures could not be converted. @throws InputError saying what is missing
void require_figure_programs();

}  // namespace ashimpact::report
