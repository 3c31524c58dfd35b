#pragma once

#include "materials/base/units.hpp"
#include "solver/contact/registry.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Whether the law knows a yield pressure.
[[nodiscard]] bool yields(Law law);

}  // namespace ashimpact
