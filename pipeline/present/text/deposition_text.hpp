// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/present/text/layout.hpp"
#include "pipeline/run/results/deposition.hpp"

namespace ashimpact {

/// The answer in sentences: what stays, with its span; where v_c is not supported by data, that first after
/// it.
[[nodiscard]] std::vector<std::string> deposition_sentences(const DepositionResult& result);

/// What the estimate is not, in one paragraph.
[[nodiscard]] std::string deposition_scope();

/// The summary of the command, of one screen.
[[nodiscard]] std::string deposition_text(const DepositionResult& result, std::size_t width = output_width());

/// "0.62 g/(m2 h)" of a flux [kg/(m2 s)].
[[nodiscard]] std::string flux_text(double flux);

}  // namespace ashimpact
