// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/json/view.hpp"
#include "pipeline/case/case.hpp"

namespace ashimpact {

/// Replaces the detachments of laws by those that a document gives, {"<law>": "<detachment>"}.
/// @param known_laws what @p choices are called in messages, such as "a law of the case"
/// @throws InputError with the JSON pointer for a law that is not among @p choices or does not admit its
/// detachment
void read_detachments(const std::optional<View>& node, std::vector<LawChoice>& choices,
                      const std::string& known_laws);

}  // namespace ashimpact
