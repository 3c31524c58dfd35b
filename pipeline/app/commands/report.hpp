// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace ashimpact {

struct ReportOptions {
    std::vector<std::string> runs;  ///< folders of artifacts
    std::string output;             ///< HTML file; empty: report.html in the one folder
};

struct FigureOptions {
    std::string name;                    ///< id of the figure
    std::vector<std::string> artifacts;  ///< files of one run, or its folder
    std::string output;                  ///< .svg, .pdf or .png
    std::string width = "double";        ///< column: "double" or "single"
};

/// `ashimpact report`: the page of one run, or of several side by side, made again from their artifacts.
void run_report_command(const ReportOptions& options, std::ostream& out);

/// `ashimpact figure`: one figure as a file.
void run_figure_command(const FigureOptions& options, std::ostream& out);

}  // namespace ashimpact
