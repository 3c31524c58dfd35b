// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/case/input_files.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

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

/// An artifact of an earlier run, checked against its schema. An edited one is taken, with a warning.
[[nodiscard]] Artifact loaded_artifact(const std::filesystem::path& folder, std::string_view file);

/// Artifacts of a finished run, checked against their schemas. @throws InputError naming the file
[[nodiscard]] Artifacts load_artifacts(const std::filesystem::path& folder,
                                       const std::vector<std::string_view>& files);

}  // namespace ashimpact
