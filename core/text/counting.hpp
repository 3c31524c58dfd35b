// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ashimpact {

/// "1 impact", "3 impacts": a number with its noun.
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// "line 4", "lines 4, 7, 9 and 12 more": numbers of lines for a message, which begins with @p word.
[[nodiscard]] std::string numbered(std::string_view word, const std::vector<std::size_t>& numbers);

}  // namespace ashimpact
