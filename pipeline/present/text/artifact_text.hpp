// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

/// How much of a result is shown.
struct ResultView {
    bool all = false;  ///< every row and every part; else long ones are shortened, with a note
    std::size_t width = output_width();  ///< characters of a line
};

/// Any JSON result for a reader: quantities in convenient units, columns as tables, histograms as bars,
/// entries of one kind (such as those of contact laws) side by side, the rest as an indented list.
[[nodiscard]] std::string result_text(const Json& result, const ResultView& view = {});

/// An artifact for a reader: its result, what it warns about, and where it comes from.
/// @param provenance whether inputs, options and citations are shown too
[[nodiscard]] std::string artifact_text(const Json& artifact, const ResultView& view = {},
                                        bool provenance = false);

}  // namespace ashimpact
