// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "pipeline/document/artifact.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// The result of a stage of a run. @param file of its artifact
[[nodiscard]] Json result_json(const Run& run, std::string_view file);

/// The options of a case that a stage works with, defaults included. @param file of its artifact
[[nodiscard]] Json options_json(const Case& data, std::string_view file);

/// Sets the result and the record of one stage from its artifact. The case has to be read first: the samples
/// of a result become those of the case, in its order.
/// @throws InputError naming the file, for values that no stage can have written and for missing samples
void read_artifact(const Artifacts& artifacts, std::string_view file, Run& run);

/// The run of the artifacts that are there.
[[nodiscard]] Run read_run(const Artifacts& artifacts);

}  // namespace ashimpact
