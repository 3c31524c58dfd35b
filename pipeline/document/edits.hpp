// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document/artifact.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

/// Refuses edits of an artifact on which only part of the later results would rest: those of values that
/// later stages do not read, or read from an earlier artifact as well. A value that was removed is no such
/// edit.
/// @param stage that writes the artifact
/// @param computed what the stage computes from the artifacts that it reads, as they are
/// @throws InputError with the file, and the JSON pointer of the first such value
void require_edits_to_count(const Artifact& edited, const Stage& stage, const Json& computed);

/// Refuses artifacts of a run that were computed from another version of one beside them: their numbers do
/// not rest on an edit of that one. @param read files whose numbers are used @throws InputError with the file
void require_up_to_date(const std::vector<Artifact>& all, const Artifacts& read);

}  // namespace ashimpact
