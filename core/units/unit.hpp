// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace ashimpact {

/// A factor times powers of base units.
struct Unit {
    double factor = 1;
    std::array<double, 4> powers{};  ///< of m, kg, s, and one for all that is not mechanical (K, A, mol ...)
};

/// Reads a unit such as "kg/m3", "kg m-3", "N.s/m", "mJ/m^2" or "metres per second": from left to right,
/// products (blank, `.`, `*`, `-`), quotients (`/`, `per`), integer powers and brackets of what unit_named()
/// knows. A number is no unit, except "1". Returns nothing for any other text. @param text from ascii_unit()
[[nodiscard]] std::optional<Unit> read_unit(std::string_view text);

/// The unit of a symbol, where case matters, or of a name in any case; both with or without SI prefixes:
/// "um", "Micron", "kilograms". Nothing if the table has none.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view name);

/// The text with `µ`, `μ`, `·`, `−`, superscript digits, no-break spaces, `Å` and `**` in ASCII.
[[nodiscard]] std::string ascii_unit(std::string_view text);

}  // namespace ashimpact
