// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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
    void count_hidden_row() { ++hidden_rows_; }

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] std::size_t hidden_rows() const { return hidden_rows_; }

    /// The sheet as a table in text: a line a row from the first one on, cells between tabs.
    [[nodiscard]] std::string as_text() const;

    static constexpr std::size_t most_columns = 1000;
    static constexpr std::size_t most_rows = 1 << 20;     ///< as many as spreadsheets have
    static constexpr std::size_t most_cells = 1'000'000;  ///< empty ones to the left of others included

  private:
    std::string name_;
    std::vector<std::vector<std::string>> rows_;
    std::size_t width_ = 0;
    std::size_t cells_ = 0;
    std::size_t hidden_rows_ = 0;
};

/// The name of a cell, counted from zero: "B7".
[[nodiscard]] std::string cell_name(std::size_t row, std::size_t column);

/// A number as a spreadsheet shows it: 15 significant digits at most, which hides that 0.1 is binary.
[[nodiscard]] std::string shown_number(double value);

/// The same for a cell in the format of per cent: "21.3 %" for 0.213.
[[nodiscard]] std::string shown_per_cent(double fraction);

/// Marks of cells that hold no number and are to be named in messages as what they are.
[[nodiscard]] std::string shown_date(std::string_view date);
[[nodiscard]] std::string shown_formula(std::string_view formula);

}  // namespace ashimpact
