// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/run/results/deposition.hpp"

namespace ashimpact::report {

/// What arrives and stays by size; around the tube; which assumption matters. Their numbers are the tables of
/// the command.
[[nodiscard]] std::vector<Figure> deposition_figures(const DepositionResult& result);

/// The report of `deposit` as one HTML file, deterministic. @param artifact of the result
[[nodiscard]] std::string deposition_page(const DepositionResult& result, const Json& artifact);

}  // namespace ashimpact::report
