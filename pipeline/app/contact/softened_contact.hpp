// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/app/contact/single_contact.hpp"

namespace ashimpact {

/// The constants of a softened contact, and factors for those that are not among the options of `contact`.
struct SoftenedContact {
    double factor;  ///< S [1]
    ContactPair pair;
    std::optional<Damping> damping;
    std::vector<std::pair<std::string, double>> parameters;  ///< factors by name [1]
    std::vector<std::pair<std::string, double>> dampings;    ///< factors of coefficients by damping law [1]
};

/// Reads --soften; none if it is not given. @param pair, damping before softening
/// @throws InputError naming the option
[[nodiscard]] std::optional<SoftenedContact> read_softening(const CommandOptions& options,
                                                            const ContactPair& pair,
                                                            const std::optional<Damping>& damping);

/// "softened" of a command's --json.
[[nodiscard]] Json softened_json(const SoftenedContact& soft);

/// Adds the lines that a reader gets of it.
void add_softened(TextList& list, const SoftenedContact& soft);

}  // namespace ashimpact
