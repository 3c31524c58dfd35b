// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/tables/text_lines.hpp"

namespace ashimpact {

/// One line of a table, cut into cells without their quotes and the blanks at their ends.
struct TableRow {
    std::size_t line = 0;
    std::vector<std::string> cells;
};

/// The separator of a line: tab, else semicolon, else comma.
[[nodiscard]] char separator_of(std::string_view line);

/// Cuts a line at the separators. Errors: InputError at the line for a quote that is not closed.
[[nodiscard]] TableRow cut_row(const TextLine& line, char separator);

/// Lines other than blank ones, comments (#) and the `sep=` line of a spreadsheet.
[[nodiscard]] std::vector<TextLine> lines_with_content(const TextLines& file);

}  // namespace ashimpact
