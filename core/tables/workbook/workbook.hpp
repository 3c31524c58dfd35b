// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/tables/text_lines.hpp"
#include "core/text/error.hpp"

/// Spreadsheets of Excel (.xlsx), LibreOffice (.ods) and what writes their formats, as the tables they hold.
namespace ashimpact {

/// One sheet of a workbook: what its cells show, row by row.
class Sheet {
  public:
    explicit Sheet(std::string name) : name_(std::move(name)) {}

    /// Puts a text into a cell; row and column are counted from zero. An empty text changes nothing.
    /// @throws InputError beyond the last row or column that a table may have
    void put(std::size_t row, std::size_t column, std::string_view text);
    /// Refuses what no table has. @throws InputError
    void require_column(std::size_t row, std::size_t column) const;
    /// States that a cell lies under a merged one, where no spreadsheet shows its text.
    void cover(std::size_t row, std::size_t column);
    /// The same of all cells of a range but its first. @throws InputError for more than a sheet has
    void merge(std::size_t first_row, std::size_t first_column, std::size_t last_row,
               std::size_t last_column);
    /// States that a cell is merged with some below it.
    void span_rows(std::size_t row, std::size_t column);
    /// Adds a comment: a line of its own below the rows, beginning with "#". @param place "B7", "a text box"
    void comment(std::string place, std::string text);
    /// States that the spreadsheet does not show the sheet.
    void hide() { hidden_ = true; }
    void count_hidden_row() { ++hidden_rows_; }
    void hide_columns(std::size_t first, std::size_t count) { hidden_columns_.emplace_back(first, count); }
    /// States that a cell holds this formula: SUM, AVERAGE and the like of cells above it sum up rows.
    void see_formula(std::size_t row, std::size_t column, const std::string& formula);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] bool hidden() const { return hidden_; }
    [[nodiscard]] std::size_t hidden_rows() const { return hidden_rows_; }
    [[nodiscard]] std::size_t hidden_columns() const;
    /// Rows, counted from one, with a formula that sums up rows "above" or "below".
    [[nodiscard]] const std::map<std::size_t, std::string_view>& summaries() const { return summaries_; }
    /// Memory that the cells take, about.
    [[nodiscard]] std::size_t bytes() const { return bytes_ + cells_ * sizeof(std::string); }
    [[nodiscard]] InputError too_large() const;
    /// Name of a cell with a text under a merged one; empty if there is none.
    [[nodiscard]] const std::string& covered() const { return covered_; }
    /// Name of the first cell with a number that is merged with some below it; empty if there is none.
    [[nodiscard]] const std::string& spanning() const { return spanning_; }
    struct Comment {
        std::string place, text;
    };
    [[nodiscard]] const std::vector<Comment>& comments() const { return comments_; }
    [[nodiscard]] std::size_t rows() const { return rows_.size(); }

    /// The sheet as a table in text: a line a row from the first one on, cells between tabs.
    [[nodiscard]] std::string as_text() const;

    static constexpr std::size_t most_columns = 1000;
    static constexpr std::size_t most_rows = 1 << 20;     ///< as many as spreadsheets have
    static constexpr std::size_t most_cells = 1'000'000;  ///< empty ones to the left of others included
    /// Of a workbook: an archive of some kilobytes may repeat a long text a million times.
    static constexpr std::size_t most_bytes = std::size_t{128} << 20;

  private:
    std::string name_;
    bool hidden_ = false;
    std::vector<std::vector<std::string>> rows_;
    std::size_t width_ = 0;
    std::size_t cells_ = 0;
    std::size_t bytes_ = 0;  ///< of the texts
    std::size_t hidden_rows_ = 0;
    std::vector<std::pair<std::size_t, std::size_t>> hidden_columns_;  ///< first ones and how many
    std::map<std::size_t, std::string_view> summaries_;
    std::string covered_{}, spanning_{};
    std::size_t merged_ = 0;  ///< cells of ranges that were looked at
    std::vector<Comment> comments_{};
};

/// The name of a cell, counted from zero: "B7".
[[nodiscard]] std::string cell_name(std::size_t row, std::size_t column);

/// Whether the bytes begin as a spreadsheet does; old Excel files count, so that they are refused as such.
[[nodiscard]] bool is_workbook(std::string_view bytes);

/// The sheets in the order of the file. Cells hold what the spreadsheet shows: results of formulas, per cent
/// as "21.3 %", dates as "2026-03-01 (a date)", error values such as "#DIV/0!".
/// @throws InputError for a file that is damaged, protected, too large or of another kind
[[nodiscard]] std::vector<Sheet> read_workbook(std::string_view bytes);

/// Selects a sheet of a workbook.
struct SheetRequest {
    std::string name{};     ///< empty: the only one that holds such a table
    std::string option;     ///< how the user names one, for messages: "--sheet"
    std::string_view code;  ///< of the findings on the file
    TextLimits limits{};
    bool (*holds_table)(const TextLines&);  ///< may throw an InputError: then none
};

/// A file with a table as lines of text: a text, or the selected sheet of a workbook, whose messages name
/// rows and cells.
class TableFile {
  public:
    /// @throws InputError if no sheet, or more than one, holds such a table, or none has that name
    TableFile(std::string_view bytes, const SheetRequest& request);

    /// The side on which a formula in a line sums up others, "above" or "below"; none without one.
    [[nodiscard]] std::optional<std::string_view> sums_up(std::size_t line) const {
        const auto found = summaries_.find(line);
        return found == summaries_.end() ? std::nullopt : std::optional(found->second);
    }

    /// The name of the sheet; none: the file is a text.
    [[nodiscard]] const std::optional<std::string>& sheet() const { return name_; }

    /// In a sheet "line 7, cell 2" is `sheet "XRD", cell B7`, and "line 7" is row 7 of it.
    [[nodiscard]] std::string place(const std::string& line) const;
    /// Where the file is a sheet, replaces lines by its rows in the findings.
    void name_rows(std::vector<Finding>& findings) const;
    /// The same, and puts findings on the whole file before them: sheets that are not read, hidden rows,
    /// Latin-1.
    void add_findings(std::vector<Finding>& findings) const;
    /// Returns what @p read makes of the lines. The places of its errors are rows and cells of a sheet.
    template <class Read>
    auto read(Read&& read) const {
        try {
            return read(*lines_);
        } catch (const InputError& error) {
            throw in_sheet(error);
        }
    }

  private:
    [[nodiscard]] InputError in_sheet(const InputError& error) const;

    std::optional<std::string> name_{};  ///< of the sheet; none: the file is a text
    std::size_t rows_ = 0;               ///< of the sheet; comments on its cells follow
    std::unique_ptr<TextLines> lines_;
    std::map<std::size_t, std::string_view> summaries_;
    std::vector<Finding> findings_;
};

}  // namespace ashimpact
