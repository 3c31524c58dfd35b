// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/view.hpp"
#include "pipeline/case/case.hpp"

namespace ashimpact {

/// A finding on a sample of the case, or on the whole case (no sample).
struct SampleFinding {
    std::string sample;
    Finding finding;
};

/// Code of findings on a statement that counts for nothing.
inline constexpr std::string_view unused_code = "unused";

/// The statements of a case that no result of a run uses, such as a wall if every sample states its contact
/// modulus; the JSON pointer and the reason are in the text. A statement of the default is no such one.
[[nodiscard]] std::vector<SampleFinding> unused_statements(const View& document, const Case& data);

}  // namespace ashimpact
