// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/json/document.hpp"

namespace ashimpact {

/// Values of an artifact that say the same thing, as they are written: of 6-fit.json the coefficients a, b,
/// c, the critical damping, which is c, and the estimate that v_c follows from; of 2-contact.json radius,
/// density and mass; of 1-modulus.json the fractions, which the modulus was computed from. A list of {"at",
/// "value"}, for the provenance; empty for other artifacts.
[[nodiscard]] Json originals_of(const std::string& schema, const Json& result);

/// Makes an edited result agree with itself: where one of such values was edited, those that say the same
/// follow it, and what was computed with the old value (an uncertainty, an estimate, an extrapolation) is
/// dropped. Quantities are converted to the unit in which they were written. @return what was done, in words.
/// @throws InputError if two of them were edited and disagree
[[nodiscard]] std::vector<std::string> reconcile(const std::string& schema, Json& result,
                                                 const Json& originals);

}  // namespace ashimpact
