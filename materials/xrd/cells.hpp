#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "materials/xrd/text_lines.hpp"

namespace ashimpact::xrd {

/// One line of a table, cut into cells: quotes taken away, blanks at the ends too.
struct Row {
    std::size_t line = 0;
    std::vector<std::string> cells;
};

/// The separator of a line: tab, else semicolon, else comma.
[[nodiscard]] char separator_of(std::string_view line);

/// Cuts a line at the separators. Errors: InputError at the line for a quote that is not closed.
[[nodiscard]] Row cut(const Line& line, char separator);

/// Lines that hold something: not blank, no comment (#), no `sep=` line of a spreadsheet.
[[nodiscard]] std::vector<Line> lines_with_content(const TextLines& file);

}  // namespace ashimpact::xrd
