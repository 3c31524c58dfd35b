// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace ashimpact {

/// A number in the notations of refinement programs and spreadsheets.
struct PrintedNumber {
    double value = 0;
    std::optional<double> standard_uncertainty{};
    bool per_cent = false;  ///< a "%" follows the number; the value is not divided by 100
};

/// Reads "0.2548+-0.0029", "12.3 ± 0.4", "12.3 +/- 0.4", "12.3(4)", "12,3 %". An uncertainty of zero counts
/// as none. Returns nothing for any other text, or a number that is not finite.
[[nodiscard]] std::optional<PrintedNumber> read_number(std::string_view text, bool decimal_comma = false);

/// Whether a cell states that there is no number: "", "-", "n.d.", "n/a", "UNDEF", "ERROR", "< 0.5".
[[nodiscard]] bool says_no_number(std::string_view text);

}  // namespace ashimpact
