// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"

namespace ashimpact {

enum class Digits {
    shortest,   ///< the fewest digits that read back as the same number
    seventeen,  ///< 17 significant digits
};

/// Writes a document with each short object or array on one line, which keeps quantities and columns
/// readable. The same document gives the same bytes. Ends with a newline.
/// @throws std::logic_error for a number that is not finite, which no result may contain
[[nodiscard]] std::string write_json(const Json& document, Digits digits = Digits::shortest);

}  // namespace ashimpact
