#pragma once

#include "pipeline/json/document.hpp"
#include "pipeline/sweep/crew/tally.hpp"
#include "pipeline/sweep/spec/plan.hpp"

namespace ashimpact {

/// The spec as it was read, and the file it was read from.
struct SpecFile {
    std::string name;
    std::string sha256;
};

/// The artifact of a finished sweep. Nothing in it depends on who did the work, when, or how often it was
/// stopped.
[[nodiscard]] Json sweep_artifact(const SweepPlan& plan, const Tally& tally, const SpecFile& spec);

}  // namespace ashimpact
