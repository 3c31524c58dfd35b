#pragma once

#include "materials/base/units.hpp"
#include "solver/contact/registry.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Whether the law knows a yield pressure.
[[nodiscard]] bool yields(Law law);

/// What the coefficient of a damping law measures.
[[nodiscard]] Dimension dimension_of(DampingLaw law);

}  // namespace ashimpact
