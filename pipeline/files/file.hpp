// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace ashimpact {

/// Bytes of the longest file that is read whole.
inline constexpr std::size_t longest_file = std::size_t{256} << 20U;

/// The bytes of a file. @throws InputError if it cannot be read or is longer than longest_file
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// The bytes of a file, or its first @p most where it is longer. @throws InputError if it cannot be read
[[nodiscard]] std::string read_start(const std::filesystem::path& path, std::size_t most);

/// Makes a folder and its parents; does nothing for an empty path. @throws InputError if that fails
void make_folder(const std::filesystem::path& folder);

/// Whether two paths lead to the same file, through links too.
[[nodiscard]] bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// Checks before a computation that a folder can be made or written into.
/// @throws InputError naming the folder, or the path that prevents it
void require_writable_folder(const std::filesystem::path& folder);

struct FileContent {
    std::filesystem::path path;
    std::string content;
};

/// Writes a file in place and waits until it is on the disk. @throws InputError if it cannot be written
void write_through(const std::filesystem::path& path, const std::string& content);

/// Marks by which own pages and figures are known.
inline constexpr std::string_view own_page_mark = "<meta name=\"generator\" content=\"ashimpact\">";
inline constexpr std::string_view own_figure_mark = "<metadata>ashimpact</metadata>";

/// Refuses to replace a file of another kind than the new content. The kind is known by a mark, the schema of
/// a JSON document, or the first line. An empty file, a device or a pipe may get anything. @throws InputError
void require_replaceable(const std::filesystem::path& path, std::string_view content);

/// Writes files so that no reader ever sees an incomplete one: each under a temporary name in the same
/// folder, then all are renamed in order. If anything fails before the first rename, the old files remain
/// unchanged. Signals that end the program are blocked only during the renames. Folders are made as needed. A
/// symbolic link is kept and its target is written. A device or a pipe is written to directly.
/// @throws InputError if a file cannot be written
void write_files(std::span<const FileContent> files);

/// The same for one file, which may replace only one of its kind, see require_replaceable().
void write_file(const std::filesystem::path& path, const std::string& content);

/// SHA-256 of some bytes, 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// Blocks the signals that end the program while it exists. Meant for renames, which are quick, and never for
/// operations that can block.
class SignalsHeld {
  public:
    SignalsHeld() {
        sigset_t ending;
        sigemptyset(&ending);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&ending, signal);
        pthread_sigmask(SIG_BLOCK, &ending, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    SignalsHeld(SignalsHeld&&) = delete;
    SignalsHeld& operator=(SignalsHeld&&) = delete;

  private:
    sigset_t before_{};
};

}  // namespace ashimpact
