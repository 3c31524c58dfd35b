// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "materials/xrd/xrd.hpp"

namespace ashimpact::xrd {

/// Divides fractions and their uncertainties by the total of the fractions, so that they add up to one.
void normalise(std::vector<PhaseFraction>& phases, double total);

/// A phase as the file of a refinement program lists it.
struct ListedPhase {
    std::string name;
    std::size_t line = 0;
    std::optional<PrintedNumber> amount{};  ///< not negative, in any unit that is the same for all
    std::optional<double> density{};        ///< [kg/m3]
};

/// Turns amounts into the fractions of a sample. A phase without an amount is left out, with a warning.
/// @param amount what the amounts are, for messages: "weight"
/// @param needed what the file needs if all amounts are zero: "GEWICHT above zero", at @p line
/// @return the total of the amounts
/// @throws InputError for a phase that is listed twice, and if all amounts are zero
double add_fractions(XrdSample& sample, const std::vector<ListedPhase>& phases, const std::string& amount,
                     const std::string& needed, std::size_t line);

}  // namespace ashimpact::xrd
