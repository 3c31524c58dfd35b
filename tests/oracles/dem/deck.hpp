// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace ashimpact::oracles {

/// What stands for each @key@ of a deck template.
using DeckValues = std::map<std::string, std::string>;

/// Returns a number that reads back as the same double.
std::string exact(double number);

/// Returns the template tests/oracles/dem/decks/<file>.
/// @throws std::runtime_error if it cannot be read
std::string deck_template(const std::string& file);

/// Returns the template with every @key@ replaced.
/// @throws std::runtime_error for a key without value, or an unpaired @
std::string fill(const std::string& deck, const DeckValues& values);

}  // namespace ashimpact::oracles
