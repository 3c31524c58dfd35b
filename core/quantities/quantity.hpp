// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/units/units.hpp"

namespace ashimpact {

/// A value with its unit; inside the program always SI.
struct Quantity {
    double value = 0;
    std::string unit = "1";
    std::optional<double> standard_uncertainty{};  ///< in the unit of the value
};

/// A quantity from a value that is already SI.
[[nodiscard]] Quantity make_quantity(double value, Dimension dimension,
                                     std::optional<double> standard_uncertainty = std::nullopt);

/// Reads "60 um", "60 +- 3 um", "60 um +- 5 %" or "60(3) um"; a number alone is SI. @throws InputError
[[nodiscard]] Quantity quantity_of_text(const std::string& text, Dimension expected);

/// Refuses an uncertainty that makes the value meaningless. @throws InputError
void require_uncertainty(const Quantity& quantity, Dimension dimension);

/// A number in the notations of refinement programs and spreadsheets.
struct PrintedNumber {
    double value = 0;
    std::optional<double> standard_uncertainty{};
    bool per_cent = false;  ///< a "%" follows the number; the value is not divided by 100
};

/// Reads "0.2548+-0.0029", "12.3 ± 0.4", "12.3 +/- 0.4", "12.3(4)", "12,3 %". An uncertainty of zero counts
/// as none. Returns nothing for any other text, or a number that is not finite.
[[nodiscard]] std::optional<PrintedNumber> read_number(std::string_view text, bool decimal_comma = false);

}  // namespace ashimpact
