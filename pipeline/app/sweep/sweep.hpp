// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/app/sweep/block.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/workers.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/present/export/subject.hpp"

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

/// The files of a sweep, all in one folder.
struct SweepFiles {
    std::filesystem::path result;
    std::filesystem::path table;       ///< the full table
    std::filesystem::path checkpoint;  ///< removed when the sweep is done
    std::filesystem::path rows;        ///< of the table, packed; removed when the sweep is done
    std::filesystem::path report;      ///< the page that shows the result

    [[nodiscard]] static SweepFiles beside(const std::filesystem::path& result);
};

/// Beginning of every checkpoint, by which a sweep recognises one.
inline constexpr std::string_view checkpoint_mark = "ashimpact sweep checkpoint";

/// The finished part of a sweep by its checkpoint; none if there is no file.
/// @throws InputError if it belongs to another spec or program, or is damaged
[[nodiscard]] std::optional<SweepProgress> load_checkpoint(const std::filesystem::path& file,
                                                           const SweepPlan& plan);

/// How often a sweep is saved, and how it is watched and interrupted.
struct SweepCare {
    double checkpoint_interval = 10;  ///< [s]
    bool show_progress = false;
    std::function<bool()> interrupted = [] { return false; };
};

/// The work of one block.
[[nodiscard]] Work work_of(const SweepPlan& plan, ImpactSolver solver);

/// Has the workers compute every chunk that the checkpoint lacks, and merges the results in the order of the
/// chunks. The finished part is saved regularly, and also if an error or an interruption ends the work.
/// @param rows the lock of the sweep, and the rows of its table
/// @returns whether all is done; false if it was interrupted
/// @throws InputError if a file cannot be written; whatever the work throws
[[nodiscard]] bool complete(SweepProgress& progress, const SweepPlan& plan, const SweepFiles& files,
                            RowLog& rows, Workers& workers, const SweepCare& care);

/// The artifact of a finished sweep, independent of processes, threads, time and interruptions.
[[nodiscard]] Json sweep_artifact(const SweepPlan& plan, const SweepProgress& progress,
                                  const InputFile& spec);

/// `ashimpact sweep`, as ashimpact-sweep runs it: reads the spec, continues from a checkpoint if there is
/// one, computes the rest with the threads of all processes, and writes the result.
void run_sweep_command(const CommandOptions& options, MpiSession& session, const ImpactSolver& solver,
                       std::ostream& out);

}  // namespace ashimpact
