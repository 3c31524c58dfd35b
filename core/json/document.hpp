// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/json_input.hpp"

namespace ashimpact {

/// The document without comments (keys that begin with "//"), at any depth.
[[nodiscard]] Json without_comments(const Json& document);

}  // namespace ashimpact
