// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/text/error.hpp"
#include "core/units/units.hpp"

namespace ashimpact {

/// What is_computable() allows.
inline constexpr double least_computable = 1e-40;
inline constexpr double greatest_computable = 1e40;

/// Whether a positive number in SI is far enough from the limits of double precision that products of powers
/// of such numbers neither overflow nor underflow.
[[nodiscard]] constexpr bool is_computable(double value) {
    return value >= least_computable && value <= greatest_computable;
}
/// The same in words.
inline constexpr std::string_view computable_range = "1e-40 to 1e40";

/// Throws InputError "<name> is <value> <unit>; allowed: a positive <dimension>" unless value > 0, finite and
/// computable.
void require_positive(std::string_view name, double value, Dimension dimension);

/// As require_positive, but infinity is allowed: a flat or fixed wall.
void require_positive_or_infinite(std::string_view name, double value, Dimension dimension);

/// Throws InputError unless value is 0 or within the range of require_positive.
void require_not_negative(std::string_view name, double value, Dimension dimension);

/// Throws InputError unless -1 < nu <= 0.5, the range in which an isotropic solid is stable.
void require_poisson_ratio(std::string_view name, double value);

/// Throws InputError unless 0 <= value <= 1.
void require_fraction(std::string_view name, double value);

/// The error for a name that is not among `known`: `no <kind> is called "<name>", did you mean "<nearest>"?`,
/// and all known names as what is allowed.
[[nodiscard]] InputError unknown_name(std::string_view kind, std::string_view name,
                                      const std::vector<std::string>& known);

}  // namespace ashimpact
