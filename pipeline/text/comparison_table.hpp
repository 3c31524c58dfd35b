#pragma once

#include <string>

#include "materials/base/view.hpp"

namespace ashimpact {

/// The result of comparison.json as the table that ends a run: a row a sample, the paper's value in brackets
/// behind ours, the measured velocity, and the sentence that sums it up.
[[nodiscard]] std::string comparison_text(const View& result);

}  // namespace ashimpact
