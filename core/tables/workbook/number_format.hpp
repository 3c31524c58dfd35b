// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ashimpact {

/// How the number of an .xlsx cell is shown. Where that is unknown, the cell may show another number.
enum class Format { number, per_cent, date, unknown };

/// One section of a number format: `[<0.1]"<"0.0" g/kg"`.
struct FormatSection {
    Format format = Format::number;
    std::string prefix{}, suffix{};  ///< texts with a meaning around the number: "<", "g/kg"
    bool in_thousands = false;       ///< "0.0,": shown a thousand times smaller
    bool has_number = false;         ///< else the texts alone are shown: "n.d."
    std::string condition{};         ///< "<0.1"; empty: by the sign of the number
};
using NumberFormat = std::vector<FormatSection>;

/// The sections of a code such as `dd.mm.yyyy`, `0.0%` or `0.0" g/kg"`. Source: ECMA-376-1, 18.8.31. A
/// section with anything that is not known here, such as `0%%`, or with a text between the digits, `0"."0`,
/// is unknown.
[[nodiscard]] NumberFormat format_of_code(std::string_view code);

/// The formats with an id but without a code in the file; unknown for those that the standard does not list.
/// Source: ECMA-376-1, 18.8.30.
[[nodiscard]] NumberFormat built_in_format(std::size_t id);

/// The section that shows a number: the first whose condition holds, else by its sign.
[[nodiscard]] const FormatSection& section_of(const NumberFormat& format, double number);

/// Whether a text beside a number means something: a unit, "<", "n.d.", unlike a bracket or a blank.
[[nodiscard]] bool has_meaning(std::string_view text);

}  // namespace ashimpact
