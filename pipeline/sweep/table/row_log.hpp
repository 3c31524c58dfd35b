#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace ashimpact {

/// Beginning of every file of rows, by which a sweep recognises one.
inline constexpr std::string_view row_log_mark = "ashimpact sweep rows\n";

/// The packed rows of the full table, in order, in a file of their own until the table is complete. Unlike an
/// HDF5 file it can be truncated to what a checkpoint contains, whenever the program was stopped. Locked
/// against a second sweep.
class RowLog {
  public:
    /// Opens the file, or makes it, and truncates it to @p size bytes; 0: to its mark alone.
    /// @throws InputError if that cannot be done, the file is shorter, or another sweep has it
    RowLog(std::filesystem::path path, std::uint64_t size);
    ~RowLog();
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;
    RowLog(RowLog&&) = delete;
    RowLog& operator=(RowLog&&) = delete;

    /// @throws InputError if the disk is full
    void append(std::string_view rows);
    /// Waits until the rows are on the disk.
    void sync();
    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    [[noreturn]] void refuse(const std::string& doing) const;

    std::filesystem::path path_;
    int file_;
    std::uint64_t size_;
};

}  // namespace ashimpact
