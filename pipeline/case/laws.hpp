#pragma once

#include "solver/contact/registry.hpp"

namespace ashimpact {

/// Whether the law knows a yield pressure.
[[nodiscard]] bool yields(Law law);

}  // namespace ashimpact
