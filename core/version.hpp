// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace ashimpact {

/// The release this program belongs to, such as "0.1.0".
[[nodiscard]] std::string_view program_version();

/// The commit the program was built from, with "-dirty" if tracked files differed from it; "unknown" if it
/// was built outside a repository and not from an archive of one.
[[nodiscard]] std::string_view program_revision();

}  // namespace ashimpact
