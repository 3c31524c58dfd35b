// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/workbook/sheet.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

void Sheet::require_column(std::size_t row, std::size_t column) const {
    if (row < most_rows && column < most_columns) return;
    throw InputError(
        "the sheet " + in_quotes(name_) + " has a text in row " + std::to_string(row + 1) + ", column " +
            std::to_string(column + 1),
        std::to_string(most_rows) + " rows and " + std::to_string(most_columns) + " columns or fewer");
}

void Sheet::put(std::size_t row, std::size_t column, std::string_view text) {
    if (trimmed(text).empty()) return;
    require_column(row, column);
    if (rows_.size() <= row) rows_.resize(row + 1);
    auto& cells = rows_[row];
    if (cells.size() <= column) {
        cells_ += column + 1 - cells.size();
        if (cells_ > most_cells)
            throw InputError("the sheet " + in_quotes(name_) + " is too large",
                             std::to_string(most_cells) + " cells or fewer, or the table as CSV");
        cells.resize(column + 1);
    }
    width_ = std::max(width_, cells.size());
    std::string& cell = cells[column];
    cell = text;
    std::replace_if(
        cell.begin(), cell.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        ' ');
}

std::string Sheet::as_text() const {
    std::string text;
    for (const auto& cells : rows_) {
        for (std::size_t column = 0; column < (cells.empty() ? 0 : width_); ++column) {
            if (column > 0) text += '\t';
            if (column >= cells.size()) continue;
            std::string cell = cells[column];
            if (cell.find('"') != std::string::npos) {  // as CSV writes a quote
                for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2)
                    cell.insert(at, 1, '"');
                cell.insert(0, 1, '"').push_back('"');
            }
            text += cell;
        }
        text += '\n';
    }
    return text;
}

std::string cell_name(std::size_t row, std::size_t column) {
    std::string letters;
    for (std::size_t rest = column + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
    return letters + std::to_string(row + 1);
}

std::string shown_number(double value) {
    return fmt::format("{:.15g}", value);
}

std::string shown_per_cent(double fraction) {
    return shown_number(100 * fraction) + " %";
}

std::string shown_date(std::string_view date) {
    return std::string(date) + " (a date)";
}

std::string shown_formula(std::string_view formula) {
    return '=' + std::string(formula) + " (a formula, saved without its result)";
}

}  // namespace ashimpact
