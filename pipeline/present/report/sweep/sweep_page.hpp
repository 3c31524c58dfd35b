// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/present/report/figure.hpp"

namespace ashimpact::report {

/// The figures of a sweep: capture fraction against each variable, histograms, sensitivity.
/// @param artifact the whole of a sweep's result
/// @throws InputError for a result whose spec is not one
[[nodiscard]] std::vector<Figure> sweep_figures(const Json& artifact);

/// The report of a sweep as one self-contained HTML file. The same result gives the same bytes.
[[nodiscard]] std::string sweep_page(const Json& artifact, const std::string& name);

}  // namespace ashimpact::report
