// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/document/artifact.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// Options of a run.
struct RunPlan {
    std::optional<std::string> case_file;  ///< none: the built-in case
    std::filesystem::path folder;          ///< of the artifacts
    std::string
        from{};  ///< stage to start from, with earlier artifacts read from the folder; empty: the case
    std::string only{};                   ///< the one stage to run, likewise; empty: all from `from` on
    bool report = true;                   ///< report.html beside the artifacts
    bool figures = false;                 ///< every figure as a file of its own, in the folder "figures"
    bool allow_outside = false;           ///< the case may name files outside its own folder
    std::optional<Stated> temperature{};  ///< of particle and wall, instead of those of the case [K]
    std::function<void(const std::string& step)> on_step{};  ///< called as each stage begins
};

/// A finished run.
struct RunSummary {
    std::vector<Artifact> written;   ///< in order, the manifest last
    std::size_t samples = 0;         ///< samples of the case
    std::string scope{};             ///< for what the results hold, see scope_sentence()
    std::string inputs{};            ///< what was read, see inputs_text()
    std::vector<InputFile> files{};  ///< those of the case
    std::vector<Remark> remarks{};   ///< of all artifacts in the folder, also those of earlier runs
    std::filesystem::path report{};  ///< file of the report; empty: none was made
    std::size_t figures = 0;         ///< files of figures written
};

/// Runs the stages. Everything is read, checked and computed first; then all artifacts are replaced at once.
/// @throws InputError, ConvergenceError; nothing is written then
[[nodiscard]] RunSummary run_stages(const RunPlan& plan);

/// The results of a case up to and with @p last_stage; nothing is written.
/// @param allow_outside whether the case may name files outside its own folder
[[nodiscard]] Run compute_run(const std::optional<std::string>& case_file, std::string_view last_stage,
                              bool allow_outside = false);

/// Like compute_run(), but returns the artifacts.
[[nodiscard]] Artifacts compute_artifacts(const std::optional<std::string>& case_file,
                                          std::string_view last_stage, bool allow_outside = false);

/// Names of the stages a run can start from.
[[nodiscard]] std::vector<std::string> stage_names();

}  // namespace ashimpact
