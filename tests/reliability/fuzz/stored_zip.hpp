// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ashimpact::test {

/// A file of an archive.
struct ZipMember {
    std::string_view name;
    std::string_view content;
};

/// A zip archive of these members, not compressed: bytes of a member are bytes of the archive.
[[nodiscard]] std::string stored_zip(const std::vector<ZipMember>& members);

}  // namespace ashimpact::test
