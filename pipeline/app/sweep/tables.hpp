// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/app/sweep/block.hpp"
#include "pipeline/present/export/impact_table.hpp"

namespace ashimpact {

/// Level of compression: higher levels hardly shrink numbers of full precision.
inline constexpr int deflate_level = 1;

/// The columns of one chunk of the table, packed as HDF5's filters shuffle and deflate would: threads do the
/// work, and the file takes the bytes unchanged. A short last chunk is padded with zeros to @p rows. A hash
/// of them and of the chunk's number, and their length, are written before them, to detect damage.
[[nodiscard]] std::string sealed_rows(std::uint64_t chunk, const std::vector<std::vector<double>>& columns,
                                      std::size_t rows);

/// Beginning of every file of rows, by which a sweep recognises one.
inline constexpr std::string_view row_log_mark = "ashimpact sweep rows\n";

/// The packed rows of the full table, in order, in a file of their own until the table is complete. Unlike an
/// HDF5 file it can be truncated to what a checkpoint contains. The file is also the lock of a sweep, with a
/// table or without: only who has it reads the checkpoint, writes and removes the files of the sweep.
class RowLog {
  public:
    /// Opens the file, or makes it, and locks it.
    /// @throws InputError if that cannot be done, or another sweep has it
    explicit RowLog(std::filesystem::path path);
    /// Unlocks the file, and removes it where it is empty.
    ~RowLog();
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;

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

  private:
    /// Whether the path still names the file that is open: who had it before may have removed it.
    [[nodiscard]] bool is_current() const;
    void truncate(std::uint64_t size);
    [[noreturn]] void refuse(const std::string& doing) const;

    std::filesystem::path path_;
    int file_ = -1;
    std::uint64_t size_ = 0;
};

/// Writes the full table as an HDF5 file from the packed rows: a dataset of doubles a column, shuffled and
/// deflated, unit and description as its attributes. The same rows give the same bytes; no half a file is
/// seen.
/// @throws InputError if the file cannot be written
void write_table(const std::filesystem::path& file, const SweepPlan& plan, const std::filesystem::path& rows);

/// Hash (SweepPlan::hash) of the spec to which a table belongs; none if no sweep wrote the file.
[[nodiscard]] std::optional<std::string> spec_of_table(const std::filesystem::path& file);

/// The bytes of an HDF5 file with a table of impacts: datasets diameter, critical_velocity, start_velocity,
/// slope, t; velocity, restitution, contact_time, damping over (diameter, t), each with its unit. The same
/// table gives the same bytes.
/// @throws std::runtime_error if HDF5 fails
[[nodiscard]] std::string impact_table_image(const ExportSubject& subject, const ImpactTable& table);

}  // namespace ashimpact
