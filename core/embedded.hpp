// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ashimpact {

/// A data file that was compiled into the program: its bytes, unchanged, for as long as the program runs.
struct EmbeddedFile {
    std::string_view path;     ///< as data/CMakeLists.txt lists it, with forward slashes
    std::string_view content;  ///< may hold any byte
};

/// The content of the file at `path` in `table`, nothing if it is not there. The table is sorted by path.
[[nodiscard]] std::optional<std::string_view> embedded_file(std::span<const EmbeddedFile> table,
                                                            std::string_view path);

/// The paths in `table` that begin with `prefix`, in order; an empty prefix gives all. The table is sorted by
/// path.
[[nodiscard]] std::vector<std::string_view> embedded_files(std::span<const EmbeddedFile> table,
                                                           std::string_view prefix);

/// The content of the file at `path`; nothing if data/CMakeLists.txt does not list it.
[[nodiscard]] std::optional<std::string_view> embedded_file(std::string_view path);

/// The paths of the embedded files that begin with `prefix` ("cases/"), in order; an empty prefix gives all.
[[nodiscard]] std::vector<std::string_view> embedded_files(std::string_view prefix);

}  // namespace ashimpact
