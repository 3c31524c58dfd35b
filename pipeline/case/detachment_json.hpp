#pragma once

#include "pipeline/case/case.hpp"
#include "pipeline/json/document.hpp"

namespace ashimpact {

/// Where the contact of each law of the case ends, and the ends that it is refused, with the reason.
[[nodiscard]] Json detachments_json(const Case& data);

}  // namespace ashimpact
