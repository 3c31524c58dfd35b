#pragma once

#include <string>

#include "pipeline/json/document.hpp"

namespace ashimpact {

enum class Digits {
    shortest,   ///< the fewest digits that read back as the same number
    seventeen,  ///< 17 significant digits
};

/// Writes a document, one object or array a line where it is short: quantities and columns stay readable. The
/// same document gives the same bytes. Ends with a newline.
/// @throws std::logic_error for a number that is not finite, which no result may hold
[[nodiscard]] std::string write_json(const Json& document, Digits digits = Digits::shortest);

}  // namespace ashimpact
