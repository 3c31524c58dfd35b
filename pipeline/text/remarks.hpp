#pragma once

#include <string>
#include <vector>

#include "pipeline/run.hpp"

namespace ashimpact {

/// The remarks of a run, one line a kind: "2 x 1-modulus.json (fine, coarse): ...". Remarks are of one kind
/// if they stand in one artifact and differ in sample, law and numbers alone; the line has the text of the
/// first.
/// @param width the lines are cut to this
[[nodiscard]] std::vector<std::string> remark_lines(const std::vector<Remark>& remarks,
                                                    const std::vector<std::string>& samples,
                                                    std::size_t width);

}  // namespace ashimpact
