// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string_view>

#include "core/json/document.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/app/sweep/block.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/tables.hpp"
#include "pipeline/app/sweep/workers.hpp"
#include "pipeline/case/input_files.hpp"

namespace ashimpact {

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
