// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/view.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

/// The result of comparison.json as the summary that ends a run, in lines of at most @p width characters:
/// which critical velocity to report of each sample, by which law and why; what was assumed; the velocities
/// of all laws beside the published ones; moduli and the velocity of adhesion alone; the sentence that sums
/// it up.
[[nodiscard]] std::string comparison_text(const View& result, std::size_t width = output_width());

}  // namespace ashimpact
