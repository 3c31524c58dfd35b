// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/document/artifact.hpp"
#include "pipeline/document/files/file.hpp"

namespace ashimpact::report {

/// File of a run's report, and the folder of its figures.
inline constexpr std::string_view report_file = "report.html";
inline constexpr std::string_view figures_folder = "figures";

/// The artifacts that a report and its figures are made of.
[[nodiscard]] const std::vector<std::string_view>& report_artifacts();

/// What is to be made of a run.
struct PresentationPlan {
    std::filesystem::path folder;  ///< where it will stand
    bool page = true;              ///< the report
    bool figures = false;          ///< each figure as SVG and PDF, for one column and for two
};

struct Presentation {
    std::filesystem::path page{};  ///< of the report; empty: none
    std::vector<FileContent> files{};
};

/// Report and figures of one run, nothing written. The same artifacts give the same bytes.
/// @throws InputError for artifacts that do not fit together, and where a program for PDF files is missing
[[nodiscard]] Presentation present(Artifacts artifacts, const PresentationPlan& plan);

/// The files that an earlier run with --figures left in the folder @p figures: by their names, and by the
/// mark in the SVG of a pair of SVG and PDF.
[[nodiscard]] std::vector<std::filesystem::path> own_figures(const std::filesystem::path& figures);

/// Refuses to begin where figures could not be converted. @throws InputError saying what is missing
void require_figure_programs();

}  // namespace ashimpact::report
