#pragma once

#include <string>

#include "pipeline/json/document.hpp"

namespace ashimpact {

/// Any JSON result for a reader: quantities in convenient units, columns as tables, the rest as an indented
/// list.
[[nodiscard]] std::string result_text(const Json& result);

/// An artifact for a reader: where it comes from, what it warns about, then its result.
[[nodiscard]] std::string artifact_text(const Json& artifact);

}  // namespace ashimpact
