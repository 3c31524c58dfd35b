// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/embedded.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ashimpact {

namespace data {
std::span<const EmbeddedFile> embedded_table();  // generated, see cmake/EmbedFiles.cmake
}

std::optional<std::string_view> embedded_file(std::span<const EmbeddedFile> table, std::string_view path) {
    const auto found = std::ranges::lower_bound(table, path, {}, &EmbeddedFile::path);
    if (found == table.end() || found->path != path) return std::nullopt;
    return found->content;
}

std::vector<std::string_view> embedded_files(std::span<const EmbeddedFile> table, std::string_view prefix) {
    std::vector<std::string_view> paths;
    for (const EmbeddedFile& file : table) {
        if (file.path.starts_with(prefix)) paths.push_back(file.path);
    }
    return paths;
}

std::optional<std::string_view> embedded_file(std::string_view path) {
    return embedded_file(data::embedded_table(), path);
}

std::vector<std::string_view> embedded_files(std::string_view prefix) {
    return embedded_files(data::embedded_table(), prefix);
}

}  // namespace ashimpact
