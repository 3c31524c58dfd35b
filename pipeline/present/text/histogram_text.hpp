// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"

namespace ashimpact {

/// {"edges": {"values", "unit"}, "counts": [..]} with an edge more than counts, as the result of a sweep has
/// it.
[[nodiscard]] bool is_histogram(const Json& value);

/// A histogram as bars, at most 16 of them, the zeros apart.
[[nodiscard]] std::string histogram_text(const Json& histogram, std::size_t indent, std::size_t width);

}  // namespace ashimpact
