// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/document.hpp"
#include "pipeline/case/case.hpp"

namespace ashimpact {

/// Where the contact of each law of the case ends, and the ends that it is refused, with the reason.
[[nodiscard]] Json detachments_json(const Case& data);

}  // namespace ashimpact
