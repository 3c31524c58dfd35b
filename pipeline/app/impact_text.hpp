// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

/// An impact and what it did, with the keys of the command's --json.
[[nodiscard]] Json impact_json(const Impact& impact, const ImpactResult& result);

/// The lines a reader gets of it.
[[nodiscard]] std::string impact_text(const Impact& impact, const ImpactResult& result);

/// The lines on the regime of an impact.
[[nodiscard]] std::string regime_text(const Regime& regime);

/// Puts the warnings of a regime on standard error.
void warn_of_regime(const Regime& regime);

}  // namespace ashimpact
