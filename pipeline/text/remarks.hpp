#pragma once

#include <string>
#include <vector>

#include "pipeline/run.hpp"

namespace ashimpact {

/// The remarks of a run, one line a kind: "2 x 1-modulus.json (fine, coarse): ...". Remarks are of one kind
/// if they stand in one artifact and differ in sample, law and numbers alone; the line says what the first
/// one says, without the reasons and consequences that follow behind a colon or a semicolon.
[[nodiscard]] std::vector<std::string> remark_lines(const std::vector<Remark>& remarks,
                                                    const std::vector<std::string>& samples);

}  // namespace ashimpact
