// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

/// Tabor parameter, yield velocities, beta and the sizes that say whether a law applies, with its warnings.
[[nodiscard]] Json regime_json(const Regime& regime);
[[nodiscard]] Regime read_regime(const View& node);

}  // namespace ashimpact
