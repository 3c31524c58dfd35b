// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/workbook/workbook.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <regex>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/tables/table_texts.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view zip_mark("PK\x03\x04", 4);
constexpr std::string_view old_excel_mark("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", 8);

std::string named_sheets(const std::vector<const Sheet*>& sheets) {
    std::vector<std::string> names;
    names.reserve(sheets.size());
    for (const Sheet* sheet : sheets)
        names.push_back(in_quotes(sheet->name()) + (sheet->hidden() ? " (hidden)" : ""));
    return joined(names);
}

/// A text about lines of a file, in words for rows of a sheet: "line 7" becomes "row 7".
std::string in_rows(std::string text) {
    for (const auto& [word, row] :
         {std::pair<std::string_view, const char*>{"line ", "row "}, {"lines ", "rows "}})
        for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) {
            const std::size_t digit = at + word.size();
            const bool begins = at == 0 || std::isalpha(static_cast<unsigned char>(text[at - 1])) == 0;
            if (begins && digit < text.size() && std::isdigit(static_cast<unsigned char>(text[digit])) != 0)
                text.replace(at, word.size(), row);
        }
    return text;
}

std::unique_ptr<TextLines> lines_of(const Sheet& sheet, TextLimits limits) {
    limits.of_sheet = true;
    // Its name is a text beside the table, which may state a unit: "Vol.-%".
    return std::make_unique<TextLines>(
        fmt::format("{}# {}{}\n", sheet.as_text(), sheet_name_mark, sheet.name()), limits);
}

bool holds_table(const Sheet& sheet, const SheetRequest& request) {
    const auto lines = lines_of(sheet, request.limits);
    try {
        return request.holds_table(*lines);
    } catch (const InputError&) {
        return false;
    }
}

/// The sheets that may be meant, those with a table if there are any.
std::vector<const Sheet*> candidates(const std::vector<Sheet>& sheets, const SheetRequest& request) {
    std::vector<const Sheet*> named;
    std::vector<const Sheet*> with_table;
    for (const Sheet& sheet : sheets) {
        if (sheet.name() == request.name) return {&sheet};
        if (sheet.empty()) continue;
        named.push_back(&sheet);
        if (holds_table(sheet, request)) with_table.push_back(&sheet);
    }
    if (!request.name.empty())
        throw InputError("there is no sheet " + in_quotes(request.name), named_sheets(named))
            .at(request.option);
    if (named.empty()) throw InputError("every sheet is empty", std::string(request.limits.content));
    return with_table.empty() ? named : with_table;
}

const Sheet& chosen(const std::vector<Sheet>& sheets, const SheetRequest& request) {
    const auto possible = candidates(sheets, request);
    if (possible.size() == 1) return *possible.front();
    if (holds_table(*possible.front(), request))
        throw InputError(std::to_string(possible.size()) + " sheets hold a table",
                         request.option + " and one of " + named_sheets(possible));
    throw InputError("no sheet holds " + std::string(request.limits.content) + " with its headings",
                     "one among " + named_sheets(possible));
}

/// Reads the number that begins at a place of the text, and moves the place behind its digits.
std::size_t take_number(std::string_view text, std::size_t& place) {
    std::size_t number = 0;
    const auto [end, status] = std::from_chars(text.data() + place, text.data() + text.size(), number);
    if (status == std::errc{}) place = static_cast<std::size_t>(end - text.data());
    return number;
}

}  // namespace

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
        if (cells_ > most_cells) throw too_large();
        cells.resize(column + 1);
    }
    if (!cells[column].empty())
        throw InputError("the cell is in the file twice", "an undamaged file").at(cell_name(row, column));
    bytes_ += text.size();
    if (bytes() > most_bytes) throw too_large();
    width_ = std::max(width_, cells.size());
    std::string& cell = cells[column];
    cell = text;
    std::replace_if(
        cell.begin(), cell.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        ' ');
}

void Sheet::cover(std::size_t row, std::size_t column) {
    if (covered_.empty() && row < rows_.size() && column < rows_[row].size() && !rows_[row][column].empty())
        covered_ = cell_name(row, column);
}

void Sheet::merge(std::size_t first_row, std::size_t first_column, std::size_t last_row,
                  std::size_t last_column) {
    for (std::size_t row = first_row; row <= last_row && row < rows_.size(); ++row)
        for (std::size_t column = first_column; column <= last_column && column < rows_[row].size();
             ++column) {
            if (++merged_ > most_cells) throw too_large();
            if (row != first_row || column != first_column) cover(row, column);
        }
    if (last_row > first_row) span_rows(first_row, first_column);
}

void Sheet::span_rows(std::size_t row, std::size_t column) {
    const bool exists = row < rows_.size() && column < rows_[row].size();
    if (spanning_.empty() && exists && read_number(rows_[row][column], true))
        spanning_ = cell_name(row, column);
}

void Sheet::comment(std::string place, std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '"'; }, ' ');
    if (trimmed(text).empty()) return;
    bytes_ += text.size();
    if (bytes() > most_bytes) throw too_large();
    comments_.push_back({std::move(place), std::string(trimmed(text))});
}

void Sheet::see_formula(std::size_t row, std::size_t column, const std::string& formula) {
    constexpr std::size_t longest = 200;  // a regular expression needs stack for each byte
    constexpr const char* range =
        R"(\((?:[^():]*[;,])?\[?\.?(\$?[A-Z]+)\$?(\d{1,7}):\.?(\$?[A-Z]+)\$?(\d{1,7}))";
    static const std::regex summary(
        "(?:SUM(?:ME)?|SUBTOTAL|AGGREGATE|AVERAGE[A-Z]*|MITTELWERT|TRIMMEAN|GEOMEAN|HARMEAN|MEDIAN|"
        "MODE[A-Z.]*|QUARTILE[A-Z.]*|PERCENTILE[A-Z.]*|STDEV[A-Z.]*|STABW[A-Z.]*|VAR[A-Z.]*|COUNT[A-Z]*|MAX|"
        "MIN)" +
            std::string(range),
        std::regex::icase);
    static const std::regex regression(
        "(?:SLOPE|INTERCEPT|RSQ|CORREL|PEARSON|STEYX|LINEST|LOGEST|TREND|GROWTH|FORECAST[A-Z.]*)" +
            std::string(range),
        std::regex::icase);
    std::smatch match;
    if (formula.size() > longest || formula.find(':') == std::string::npos ||
        (!std::regex_search(formula, match, summary) && !std::regex_search(formula, match, regression)))
        return;
    const auto cell = [](std::string letters, const std::string& digits) {
        std::erase(letters, '$');
        return letters + digits;
    };
    const std::size_t last = std::stoul(match.str(4));
    const std::size_t first = std::stoul(match.str(2));
    const bool above = last <= row;
    const bool apart = first < last && (above || first > row + 1);
    const std::string own = cell_name(last - 1, column);
    const bool of_column = cell(match.str(1), match.str(4)) == own && cell(match.str(3), match.str(4)) == own;
    if (apart && (of_column || std::regex_search(formula, regression)))
        summaries_.emplace(row + 1, above ? "above" : "below");
}

std::size_t Sheet::hidden_columns() const {
    std::size_t hidden = 0;
    for (const auto& [first, count] : hidden_columns_)
        hidden += std::min(width_, first + count) - std::min(width_, first);
    return hidden;
}

InputError Sheet::too_large() const {
    return InputError("the sheet " + in_quotes(name_) + " is too large",
                      std::to_string(most_cells) + " cells and " + std::to_string(most_bytes >> 20) +
                          " MB in all, or fewer, or the table as CSV");
}

std::string Sheet::as_text() const {
    std::string text;
    for (const auto& cells : rows_) {
        for (std::size_t column = 0; column < (cells.empty() ? 0 : width_); ++column) {
            if (column > 0) text += '\t';
            if (column >= cells.size()) continue;
            const std::string& cell = cells[column];
            constexpr std::array<std::pair<std::string_view, std::string_view>, 1> doubled{{{"\"", "\"\""}}};
            const bool has_quote = cell.find('"') != std::string::npos;  // then quoted as in CSV
            text += has_quote ? '"' + replaced(cell, doubled) + '"' : cell;
        }
        text += '\n';
    }
    for (const Comment& each : comments_) text += "# comment on " + each.place + ": " + each.text + '\n';
    return text;
}

std::string cell_name(std::size_t row, std::size_t column) {
    std::string letters;
    for (std::size_t rest = column + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
    return letters + std::to_string(row + 1);
}

bool is_workbook(std::string_view bytes) {
    return bytes.starts_with(zip_mark) || bytes.starts_with(old_excel_mark);
}

TableFile::TableFile(std::string_view bytes, const SheetRequest& request) {
    if (!is_workbook(bytes)) {
        if (!request.name.empty())
            throw InputError("a sheet is named, and the file is no spreadsheet", "an .xlsx or .ods");
        lines_ = std::make_unique<TextLines>(bytes, request.limits);
        if (lines_->was_latin1())
            findings_.push_back(
                {request.code, Severity::background, "the file is not UTF-8 and was read as Latin-1"});
        return;
    }
    const std::vector<Sheet> sheets = read_workbook(bytes);
    const Sheet& sheet = chosen(sheets, request);
    name_ = sheet.name();
    rows_ = sheet.rows();
    if (!sheet.covered().empty())
        throw InputError("the cell has a value that a merged cell hides",
                         "cells that are not merged, or this one empty")
            .at("sheet " + in_quotes(*name_) + ", cell " + sheet.covered());
    if (!sheet.spanning().empty())
        findings_.push_back({request.code, Severity::remark,
                             fmt::format("the number in {} is merged with cells below it: it counts for the "
                                         "first row alone, unless it names a sample",
                                         sheet.spanning())});
    constexpr std::size_t most_comments = 10;
    for (std::size_t i = 0; i < std::min(sheet.comments().size(), most_comments); ++i)
        findings_.push_back({request.code, Severity::remark,
                             fmt::format("the comment on {}, {}, is no part of the table",
                                         sheet.comments()[i].place, in_quotes(sheet.comments()[i].text))});
    if (sheet.comments().size() > most_comments)
        findings_.push_back({request.code, Severity::remark,
                             fmt::format("{} more comments are no part of the table",
                                         sheet.comments().size() - most_comments)});
    summaries_ = sheet.summaries();
    try {
        lines_ = lines_of(sheet, request.limits);
    } catch (const InputError& error) {
        throw in_sheet(error);
    }
    std::vector<const Sheet*> others;
    for (const Sheet& other : sheets)
        if (&other != &sheet && !other.empty()) others.push_back(&other);
    if (!others.empty())
        findings_.push_back(
            {request.code, Severity::remark,
             "the sheet " + named_sheets({&sheet}) + " is read, not " + named_sheets(others)});
    else if (sheet.hidden())
        findings_.push_back(
            {request.code, Severity::remark, "the sheet " + named_sheets({&sheet}) + " is read"});
    for (const auto& [what, count] :
         {std::pair{"rows", sheet.hidden_rows()}, std::pair{"columns", sheet.hidden_columns()}})
        if (count > 0)
            findings_.push_back(
                {request.code, Severity::remark, fmt::format("hidden {} are read as well: {}", what, count)});
}

std::string TableFile::place(const std::string& line) const {
    if (!name_) return line;
    const std::string sheet = "sheet " + in_quotes(*name_);
    constexpr std::string_view word = "line ";
    if (!line.starts_with(word)) return line.empty() ? sheet : sheet + ": " + line;
    std::size_t end = word.size();
    const std::size_t row = take_number(line, end);
    if (row > rows_) return sheet + ", comments" + line.substr(end);
    constexpr std::string_view cell_word = ", cell ";
    if (!std::string_view(line).substr(end).starts_with(cell_word))
        return sheet + ", row " + std::to_string(row) + line.substr(end);
    end += cell_word.size();
    const std::size_t column = take_number(line, end);
    return sheet + ", cell " + cell_name(row - 1, column - 1) + line.substr(end);
}

InputError TableFile::in_sheet(const InputError& error) const {
    return name_ ? InputError(in_rows(error.problem()), in_rows(error.allowed())).at(place(error.place()))
                 : error;
}

void TableFile::name_rows(std::vector<Finding>& findings) const {
    if (!name_) return;
    for (Finding& each : findings) each.text = in_rows(std::move(each.text));
}

void TableFile::add_findings(std::vector<Finding>& findings) const {
    name_rows(findings);
    findings.insert(findings.begin(), findings_.begin(), findings_.end());
}

}  // namespace ashimpact
