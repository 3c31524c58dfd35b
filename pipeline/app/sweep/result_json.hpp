// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/document.hpp"
#include "pipeline/app/sweep/workers/block.hpp"

namespace ashimpact {

/// Name and hash of the file of the spec.
struct SpecFile {
    std::string name;
    std::string sha256;
};

/// The artifact of a finished sweep. It does not depend on the number of processes and threads, on time, or
/// on interruptions.
[[nodiscard]] Json sweep_artifact(const SweepPlan& plan, const SweepProgress& progress, const SpecFile& spec);

}  // namespace ashimpact
