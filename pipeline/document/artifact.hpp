// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/view.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// One artifact: its file name, its document and the bytes it was read from or will be written as.
struct Artifact {
    std::string file;
    std::shared_ptr<const Json> document;  ///< shared by its copies
    std::string bytes;
    /// The file it was read from, for 0-case.json also the case file; for messages. Empty: it was computed.
    std::string place{};
    bool edited = false;            ///< its result is not what ashimpact wrote
    std::vector<Finding> doubts{};  ///< about values of an edited result that are far from plausible
};

/// The artifacts of a run.
class Artifacts {
  public:
    void add(Artifact artifact) { artifacts_.push_back(std::move(artifact)); }
    /// The artifact of that file name. @throws std::logic_error if it was not added
    [[nodiscard]] const Artifact& at(std::string_view file) const;
    /// Whether it was added.
    [[nodiscard]] bool has(std::string_view file) const;
    /// The name of an artifact in messages; of a computed one that of the first, which it was computed from.
    [[nodiscard]] const std::string& place_of(std::string_view file) const;
    /// All of them, in the order in which they were added.
    [[nodiscard]] const std::vector<Artifact>& list() const { return artifacts_; }

  private:
    std::vector<Artifact> artifacts_;
};

/// Name of the schema of an artifact.
[[nodiscard]] std::string schema_of(std::string_view file);

/// The envelope of an artifact beside its result.
struct Envelope {
    StageRecord record{};
    std::vector<InputFile> inputs{};
    Json options = Json::object();
    bool rests_on_edit = false;  ///< it was computed from an edited artifact
};

/// An artifact in its envelope.
/// @param run identity of its run; empty: it starts one
[[nodiscard]] Artifact sealed_artifact(const Envelope& envelope, Json result, const std::string& run);

/// The remark on an edited artifact, behind the name of its file.
inline constexpr std::string_view edited_words = "was edited after ashimpact wrote it";

/// An artifact of an earlier run, checked against its schema. An edited one is taken, with a warning.
[[nodiscard]] Artifact loaded_artifact(const std::filesystem::path& folder, std::string_view file);

/// The notes of an artifact; of one without "notes" its warnings, as remarks of code "warning".
[[nodiscard]] std::vector<Note> read_notes(const View& artifact);

/// Identity of the run that an artifact is of. @throws InputError if it has none
[[nodiscard]] std::string run_of(const Json& document);

/// Writes a hash of its result, which reveals later edits, into the provenance of an artifact.
void seal_result(Json& document);

/// Whether the result of an artifact is not what ashimpact wrote. Layout and comments do not count.
[[nodiscard]] bool is_edited(const Json& document);

/// Refuses artifacts of different runs. @throws InputError naming one that does not belong to the first
void require_one_run(const std::vector<Artifact>& artifacts);

/// Checks every quantity of an edited result: it is possible, and lies inside of its interval.
/// @throws InputError with the JSON pointer of the first that does not
void require_possible_result(const Json& document);

}  // namespace ashimpact
