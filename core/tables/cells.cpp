// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/cells.hpp"

#include <algorithm>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Removes a cell in quotes from the front of `text`, which begins behind the opening quote, and returns its
/// content.
std::string take_quoted(std::string_view& text, std::size_t line) {
    std::string cell;
    while (true) {
        const auto quote = text.find('"');
        if (quote == std::string_view::npos)
            throw InputError("a quote is not closed", "quotes in pairs, each cell in one line")
                .at(at_line(line));
        cell += text.substr(0, quote);
        text.remove_prefix(quote + 1);
        if (!text.starts_with('"')) return cell;
        cell += '"';
        text.remove_prefix(1);
    }
}

}  // namespace

char separator_of(std::string_view line) {
    for (const char candidate : {'\t', ';'})
        if (line.find(candidate) != std::string_view::npos) return candidate;
    return ',';
}

TableRow cut_row(const TextLine& line, char separator) {
    TableRow row{.line = line.number, .cells = {}};
    std::string_view rest = line.text;
    while (true) {
        const auto blank = std::min(rest.find_first_not_of(' '), rest.size());
        std::string cell;
        if (rest.substr(blank).starts_with('"')) {
            rest.remove_prefix(blank + 1);
            cell = take_quoted(rest, line.number);
        }
        const auto end = rest.find(separator);
        cell += rest.substr(0, end);
        row.cells.emplace_back(trimmed(cell));
        if (end == std::string_view::npos) return row;
        rest.remove_prefix(end + 1);
    }
}

std::vector<TextLine> lines_with_content(const TextLines& file) {
    std::vector<TextLine> lines;
    for (const TextLine& line : file.lines()) {
        const std::string_view text = trimmed(line.text);
        if (!text.empty() && !text.starts_with('#') && !lower_case(text).starts_with("sep="))
            lines.push_back(line);
    }
    return lines;
}

}  // namespace ashimpact
