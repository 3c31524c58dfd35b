// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace ashimpact {

/// Whether the text is made of units, operators and exponents. UDUNITS-2 would also take factors ("5 m"),
/// origins and times of day; in the unit of a quantity they can only be mistakes.
[[nodiscard]] bool names_a_unit(std::string_view unit);

}  // namespace ashimpact
