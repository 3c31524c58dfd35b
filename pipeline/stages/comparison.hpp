#pragma once

#include "pipeline/stages/stage.hpp"

namespace ashimpact {

/// The critical velocities of every kind side by side, published values beside ours, and what their ratio
/// says.
[[nodiscard]] StageOutput comparison_stage(const Artifacts& before);

}  // namespace ashimpact
