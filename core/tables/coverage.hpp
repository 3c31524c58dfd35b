// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/finding.hpp"

namespace ashimpact {

/// The coverage of uncertainties that the heading of a column states, as in "Unsicherheit (2s)", "U (k=2)",
/// "error (95 %)" or "v_in ± 2 sigma [m/s]".
struct StatedCoverage {
    std::string rest;    ///< the heading without the statement, "Unsicherheit"
    double factor = 1;   ///< numbers of the column over standard uncertainties: 2, and 1.96 for 95 %
    std::string stated;  ///< "2s"; empty if nothing is stated
    /// Why the uncertainties cannot be read, with the remedy; empty if they can.
    std::string problem;
};

/// Finds a multiple of the standard uncertainty (2s, 2 sigma, 2σ, 2 SD, k = 2), or a coverage (95 %) beside
/// the name of an uncertainty or "±". A bare "2s" counts in brackets, after "±" or a word for an uncertainty,
/// and alone. A confidence interval without "±" and an expanded uncertainty without k are problems.
[[nodiscard]] StatedCoverage read_coverage(std::string_view heading);

/// Whether a text is a word for an uncertainty and names no quantity: "Fehler", "u", "s.u.", "±".
[[nodiscard]] bool is_uncertainty_word(std::string_view text);

/// Remarks of that code on columns, given with their headings, whose uncertainties are not standard ones: one
/// for all that are divided by the same number, one for each that cannot be read.
[[nodiscard]] std::vector<Finding> coverage_findings(
    std::string_view code, const std::vector<std::pair<std::string, StatedCoverage>>& columns);

}  // namespace ashimpact
