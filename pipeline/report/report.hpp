#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/files/file.hpp"
#include "pipeline/stages/stage.hpp"

namespace ashimpact::report {

/// File of a run's report.
inline constexpr std::string_view report_file = "report.html";

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

/// Refuses to begin where figures could not be converted. @throws InputError saying what is missing
void require_figure_programs();

}  // namespace ashimpact::report
