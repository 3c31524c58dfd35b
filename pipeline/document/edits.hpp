// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "pipeline/document/artifact.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"

/// Edited artifacts: what is computed or shown from the files of a run rests on one state of it.
namespace ashimpact {

/// Whether the numbers of an artifact are used.
using IsUsed = std::function<bool(std::string_view file)>;

/// Refuses artifacts of a run that were computed from another version of one beside them: their numbers do
/// not rest on an edit of that one. @throws InputError with the file, and the stage to run from
void require_up_to_date(const std::vector<Artifact>& all, const IsUsed& is_used);

/// Refuses edits on which only part of the later results would rest: those of values that later stages do not
/// read, or read from an earlier artifact as well. A value that was removed from a sample is no such edit. To
/// find them, the stage of each edited artifact is computed from those that it reads, loaded if need be.
/// @throws InputError with the file, and the JSON pointer of the first such value
void require_edits_to_count(const Artifacts& artifacts, ContactModels& models);

/// Refuses artifacts of different runs, and used ones that mix two states of a run. An artifact is used with
/// all that it was computed from. An edit was checked by the run that computed another artifact from it.
/// @throws InputError with the file
void require_one_state(const Artifacts& artifacts, std::span<const std::string_view> used);

/// Artifacts of a finished run, checked against their schemas, in one state. @throws InputError with the file
[[nodiscard]] Artifacts load_artifacts(const std::filesystem::path& folder,
                                       const std::vector<std::string_view>& files);

}  // namespace ashimpact
