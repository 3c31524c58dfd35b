// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/run/results/comparison.hpp"

namespace ashimpact {

/// The comparison as the summary that ends a run, in lines of at most @p width characters: which critical
/// velocity to report of each sample, by which law and why; what was assumed; the velocities of all laws
/// beside the published ones; moduli and the velocity of adhesion alone; the conclusion.
[[nodiscard]] std::string comparison_text(const ComparisonResult& result, std::size_t width = output_width());

/// The same of the result of comparison.json. @throws InputError for values that no stage can have written
[[nodiscard]] std::string comparison_text(Json result, std::size_t width = output_width());

}  // namespace ashimpact
