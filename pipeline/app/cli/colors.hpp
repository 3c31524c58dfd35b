// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace ashimpact {

/// What --color asks for: "auto" is color on a terminal, unless NO_COLOR is set or TERM is dumb.
void choose_color(std::string_view when);

/// Whether what goes to this file descriptor is colored.
[[nodiscard]] bool is_colored(int descriptor);

/// The text for a terminal: headings of tables bold, "warning:" yellow.
[[nodiscard]] std::string with_colors(std::string_view text);

/// An error in red.
[[nodiscard]] std::string error_in_color(std::string_view text);

}  // namespace ashimpact
