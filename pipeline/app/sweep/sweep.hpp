// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/app/sweep/block.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/workers.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/present/export/impact_table.hpp"

namespace ashimpact {

/// Level of compression: higher levels hardly shrink numbers of full precision.
inline constexpr int deflate_level = 1;

/// The columns of one chunk, shuffled and deflated as HDF5 would and padded with zeros to @p rows; the file
/// takes them unchanged. A hash of them and of the chunk's number, and their length, stand before them.
[[nodiscard]] std::string sealed_rows(std::uint64_t chunk, const std::vector<std::vector<double>>& columns,
                                      std::size_t rows);

/// Beginning of every file of rows, by which a sweep recognises one.
inline constexpr std::string_view row_log_mark = "ashimpact sweep rows\n";

/// The packed rows of the full table until it is complete. Unlike an HDF5 file they can be truncated to a
/// checkpoint. The file is also the lock of a sweep: only its owner writes and removes files of the sweep.
class RowLog {
  public:
    /// Opens or makes the file and locks it. @throws InputError if that fails, or another sweep has it
    explicit RowLog(std::filesystem::path path);
    /// Unlocks the file, and removes it where it is empty.
    ~RowLog();
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;

    /// Truncates to @p size bytes, 0: to the mark; then appends. @throws InputError if it fails or is shorter
    void resume(std::uint64_t size);
    /// Truncates the file to nothing. @throws InputError if that fails
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

/// Writes the full table as HDF5, a dataset of doubles a column with unit and description; whole or not at
/// all. The same rows give the same bytes. @throws InputError if the file cannot be written
void write_table(const std::filesystem::path& file, const SweepPlan& plan, const std::filesystem::path& rows);

/// Hash (SweepPlan::hash) of the spec to which a table belongs; none if no sweep wrote the file.
[[nodiscard]] std::optional<std::string> spec_of_table(const std::filesystem::path& file);

/// HDF5 file of a table of impacts: diameter, critical_velocity, start_velocity, slope, t; velocity,
/// restitution, contact_time, damping over (diameter, t). The same table gives the same bytes. @throws
/// std::runtime_error
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

/// Progress of a checkpoint, if any. @throws InputError if damaged, or of another spec or program
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

/// Computes what the checkpoint lacks and merges it in the order of the chunks; saves regularly, and on an
/// error or interruption. @param rows lock of the sweep, and rows of its table
/// @returns false if interrupted @throws InputError if a file cannot be written; whatever the work throws
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
