// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace ashimpact {

/// Beginning of every file of rows, by which a sweep recognises one.
inline constexpr std::string_view row_log_mark = "ashimpact sweep rows\n";

/// The packed rows of the full table, in order, in a file of their own until the table is complete. Unlike an
/// HDF5 file it can be truncated to what a checkpoint contains, whenever the program was stopped.
///
/// The file is also the lock of a sweep, with a table or without: who has it reads the checkpoint, writes and
/// removes the files of the sweep, and no other sweep does.
class RowLog {
  public:
    /// Opens the file, or makes it, and locks it.
    /// @throws InputError if that cannot be done, or another sweep has it
    explicit RowLog(std::filesystem::path path);
    /// Unlocks the file, and removes it where it is empty.
    ~RowLog();
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;
    RowLog(RowLog&&) = delete;
    RowLog& operator=(RowLog&&) = delete;

    /// Truncates the file to @p size bytes, after which rows are appended; 0: to its mark alone.
    /// @throws InputError if that cannot be done, or the file is shorter
    void resume(std::uint64_t size);
    /// Truncates the file to nothing.
    /// @throws InputError if that cannot be done
    void clear();
    /// @throws InputError if the disk is full
    void append(std::string_view rows);
    /// Waits until the rows are on the disk.
    void sync();
    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    /// Whether the path still names the file that is open: who had it before may have removed it.
    [[nodiscard]] bool is_current() const;
    void truncate(std::uint64_t size);
    [[noreturn]] void refuse(const std::string& doing) const;

    std::filesystem::path path_;
    int file_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace ashimpact
