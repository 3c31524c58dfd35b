// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// A note of an artifact of a run.
struct Remark {
    std::string file;  ///< of the artifact
    Note note;
};

/// The remarks of one kind.
struct RemarkLine {
    std::string text;
    /// Whether it may change what the reader reports; see Severity.
    bool decides = true;
};

/// The remarks of a run, one line a kind: "2 x 6-fit.json (fine; dmt, jkr): ...". Remarks are of one kind if
/// they are in one artifact and differ in sample, law and numbers alone; the line has the text of the first
/// one, without the reasons and consequences that follow a colon or a semicolon.
/// @param samples number of samples of the run
[[nodiscard]] std::vector<RemarkLine> remark_lines(const std::vector<Remark>& remarks, std::size_t samples);

}  // namespace ashimpact
