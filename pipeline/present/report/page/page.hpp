// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact::report {

/// The report of one run, or of several side by side, as one self-contained HTML file, deterministic.
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

/// Each figure of a run for one column and for two, as SVG and as PDF, in a folder of @p folder. The same run
/// gives the same bytes. @throws InputError if the program that makes PDF files is missing
[[nodiscard]] std::vector<FileContent> figure_files(const RunData& run, const std::filesystem::path& folder);

/// The files that an earlier run left in the folder @p figures, known by name and by the mark in the SVG.
[[nodiscard]] std::vector<std::filesystem::path> own_figures(const std::filesystem::path& figures);

/// A figure as HTML: drawings, caption, readout, numbers as table and CSV. @param id link target, unique
[[nodiscard]] std::string html_of(const Figure& figure, const std::string& id);

/// A part that scrolls by itself. @param label for those who do not see it, escaped
[[nodiscard]] std::string html_scroll(const std::string& label, const std::string& content,
                                      std::string_view look = "scroll");

/// A section under its heading, which is a link target.
[[nodiscard]] std::string html_section(std::string_view id, std::string_view title,
                                       const std::string& content);

/// A list of notes, which are HTML.
[[nodiscard]] std::string html_notes(const std::vector<std::string>& notes);

/// Links to figures and to the provenance.
[[nodiscard]] std::string html_contents(const std::vector<std::string_view>& figures);

/// Escaped texts of a JSON list.
[[nodiscard]] std::vector<std::string> escaped_texts(const Json& list);

/// Program, inputs, options and citations of an artifact that is no part of a run, as a section.
[[nodiscard]] std::string html_provenance(const Json& artifact);

/// A whole page: head with the strict content security policy, style and script.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

/// Whether a file is a page of ours, which may be replaced or removed.
[[nodiscard]] bool is_own_page(const std::filesystem::path& file);

/// An escaped text with the symbols in it set as such: "v_in", "e_n".
[[nodiscard]] std::string with_subscripts(std::string text);

/// The text with a capital letter first.
[[nodiscard]] std::string capitalized(std::string text);

/// "work_of_adhesion" as "work of adhesion".
[[nodiscard]] std::string words_of(std::string key);

/// A user's name in HTML.
[[nodiscard]] std::string html_name(std::string_view name);

}  // namespace ashimpact::report
