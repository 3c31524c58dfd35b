#pragma once

#include "pipeline/json/document.hpp"
#include "solver/regime/regime.hpp"

namespace ashimpact {

/// Tabor parameter, yield velocities, beta and the sizes that say whether a law applies, with its warnings.
[[nodiscard]] Json regime_json(const Regime& regime);

}  // namespace ashimpact
