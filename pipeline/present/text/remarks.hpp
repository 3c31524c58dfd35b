// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/run/run.hpp"

namespace ashimpact {

/// The remarks of one kind.
struct RemarkLine {
    std::string text;
    /// Whether it may change what the reader reports. Others tell of assumptions and models that every such
    /// run has, and of what the summary says as well.
    bool decides = true;
};

/// The remarks of a run, one line a kind: "2 x 6-fit.json (fine; dmt, jkr): ...". Remarks are of one kind if
/// they stand in one artifact and differ in sample, law and numbers alone; the line says what the first one
/// says, without the reasons and consequences that follow behind a colon or a semicolon.
[[nodiscard]] std::vector<RemarkLine> remark_lines(const std::vector<Remark>& remarks,
                                                   const std::vector<std::string>& samples);

}  // namespace ashimpact
