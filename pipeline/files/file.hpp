#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <span>
#include <string>

namespace ashimpact {

/// The bytes of a file, or its first `most` where it is longer. @throws InputError if it cannot be read
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::size_t most = std::numeric_limits<std::size_t>::max());

struct FileContent {
    std::filesystem::path path;
    std::string content;
};

/// Writes files so that no reader ever sees half of one: each under another name beside its place, then all
/// renamed in order. If anything fails before the first rename, what was there stays as it was. Signals that
/// end the program wait until it is done. Folders are made as needed. A symbolic link stays one: what it
/// names is written. A device or a pipe is written to as it is.
/// @throws InputError if a file cannot be written
void write_files(std::span<const FileContent> files);

/// The same for one file.
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace ashimpact
