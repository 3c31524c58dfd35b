// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/present/report/data/run_data.hpp"

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

}  // namespace ashimpact::report
