// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ashimpact {

/// The help of a command in lines of at most @p width characters. Descriptions are broken behind their
/// column, commands of examples with a backslash, so that they can be pasted as they stand.
/// @param program what starts this program, which stands for "ashimpact" at the head of an example
[[nodiscard]] std::string help_layout(const std::string& help, std::size_t width, const std::string& program);

}  // namespace ashimpact
