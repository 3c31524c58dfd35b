// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

/// One line of a file, without its end, counted from one.
struct TextLine {
    std::size_t number = 0;
    std::string_view text;
};

/// The expected content of a text file, and its greatest length.
struct TextLimits {
    std::string_view content = "a table";       ///< named in messages, such as "an XRD result"
    std::size_t bytes = std::size_t{16} << 20;  ///< greatest length of the file [byte]
    std::size_t lines = 100'000;                ///< greatest number of lines
    bool of_sheet = false;                      ///< whether it is a sheet of a workbook
};

/// A text file in uniform encoding: UTF-8 without byte-order mark, lines without CR.
class TextLines {
  public:
    /// UTF-16 with its mark is read, and a quoted cell over two lines. Errors: InputError with a line number
    /// for an empty, blank or binary file, for damaged UTF-16, for a line of more than a megabyte, and for a
    /// file that is longer than `limits`.
    TextLines(std::string_view bytes, const TextLimits& limits);

    TextLines(const TextLines&) = delete;
    TextLines& operator=(const TextLines&) = delete;

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::vector<TextLine>& lines() const { return lines_; }
    [[nodiscard]] std::size_t last_line() const { return lines_.back().number; }

    /// Whether the bytes were not valid UTF-8 and were read as Latin-1.
    [[nodiscard]] bool was_latin1() const { return was_latin1_; }
    /// Whether the lines are a sheet of a workbook.
    [[nodiscard]] bool of_sheet() const { return of_sheet_; }

  private:
    std::string text_;
    std::vector<TextLine> lines_;
    bool was_latin1_ = false;
    bool of_sheet_;
};

/// A title, comment or note for a one-line message, as in_quotes(), but whole up to 400 bytes: a unit may
/// stand at its end.
[[nodiscard]] std::string title_in_quotes(std::string_view title);

/// "line N" for the place of an error.
[[nodiscard]] std::string at_line(std::size_t number);

/// Throws InputError at a line.
[[noreturn]] void refuse_line(std::size_t number, const std::string& problem, const std::string& allowed);

/// "line N, cell M" for the place of an error; the column is counted from zero.
[[nodiscard]] std::string at_cell(std::size_t line, std::size_t column);

/// One line of a table, cut into cells without their quotes and the blanks at their ends.
struct TableRow {
    std::size_t line = 0;
    std::vector<std::string> cells;
};

/// The separator of a line: tab, else semicolon, else comma.
[[nodiscard]] char separator_of(std::string_view line);

/// Cuts a line at the separators. Errors: InputError at the line for a quote that is not closed.
[[nodiscard]] TableRow cut_row(const TextLine& line, char separator);

/// Calls @p visitor(cell, column) for the cells of a line as cut_row() cuts it; without quotes, nothing is
/// copied.
template <class Visitor>
void for_each_cell(const TextLine& line, char separator, Visitor&& visitor) {
    std::size_t column = 0;
    if (line.text.find('"') != std::string_view::npos) {
        for (const std::string& cell : cut_row(line, separator).cells)
            visitor(std::string_view(cell), column++);
        return;
    }
    for (std::string_view rest = line.text;; ++column) {
        const auto end = rest.find(separator);
        visitor(trimmed(rest.substr(0, end)), column);
        if (end == std::string_view::npos) return;
        rest.remove_prefix(end + 1);
    }
}

/// Whether a line is a second heading line, with the units of the first: each cell is empty, "-" or a unit,
/// in brackets or bare. Adds the units to the cells of the heading: "v_in [mm/s]".
[[nodiscard]] bool take_units(TableRow& heading, const TableRow& line,
                              const std::function<bool(std::string_view)>& is_unit);

/// Whether the cells of a row are a note: the first begins with the sign of a footnote, is a word for remarks
/// beside others, or states a remark, and no other is a number or a word for none. "* by ICP;in g/kg",
/// "Comment;;by volume".
[[nodiscard]] bool is_note(std::span<const std::string> cells);

/// Removes lines of text from the end of a table, behind a blank line or announced: "* not detected", "Note:
/// 40 kV, 40 mA". Remarks of @p code name them. @param first index of the first line below the heading
[[nodiscard]] std::vector<Finding> take_notes(std::vector<TextLine>& lines, std::size_t first, char separator,
                                              std::string_view code);

/// Lines other than blank ones, comments (#) and the `sep=` line of a spreadsheet. A comment above the first
/// line is a heading if that line has numbers in as many cells, as numpy.savetxt() writes it.
[[nodiscard]] std::vector<TextLine> lines_with_content(const TextLines& file);

}  // namespace ashimpact
