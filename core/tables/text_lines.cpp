// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/text_lines.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/quantities/quantity.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;

/// Whether bytes begin as UTF-16, such as the "Unicode text" of Excel.
bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

/// UTF-16 as UTF-8. @throws InputError for half characters
std::string decoded_utf16(std::string_view bytes) {
    const std::size_t low = bytes.front() == '\xff' ? 0 : 1;  // place of the lower byte of a unit
    const auto unit = [&](std::size_t at) {
        return static_cast<unsigned char>(bytes[at + low]) +
               256U * static_cast<unsigned char>(bytes[at + 1 - low]);
    };
    std::string text;
    bool whole = bytes.size() % 2 == 0;
    for (std::size_t at = 2; whole && at < bytes.size(); at += 2) {
        char32_t code = unit(at);
        if (code >= 0xd800 && code < 0xe000) {
            whole = code < 0xdc00 && at + 2 < bytes.size() && (unit(at + 2) & 0xfc00U) == 0xdc00U;
            if (!whole) break;
            at += 2;
            code = 0x10000 + ((code & 0x3ffU) << 10U) + (unit(at) & 0x3ffU);
        }
        const unsigned more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
        constexpr std::array<unsigned, 4> leads{0, 0xc0, 0xe0, 0xf0};
        text += static_cast<char>(leads[more] | (code >> (6 * more)));
        for (unsigned k = more; k-- > 0;) text += static_cast<char>(0x80U | ((code >> (6 * k)) & 0x3fU));
    }
    if (!whole) refuse_line(1, "this begins as UTF-16 and is damaged", "whole characters, or UTF-8 text");
    return text;
}

/// Refuses a file that cannot be a text, before anything is copied.
void check_bytes(std::string_view bytes, const TextLimits& limits) {
    std::size_t line_start = 0;
    std::size_t line = 1;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const unsigned char c = static_cast<unsigned char>(bytes[i]);
        if (c == '\n' || c == '\r') {
            line_start = i + 1;
            const bool crlf = c == '\r' && bytes.substr(i + 1).starts_with('\n');
            line += crlf ? 0 : 1;
        } else if (i - line_start >= longest_line) {
            refuse_line(line, "the line is longer than a megabyte", "a text file with lines");
        } else if ((c < 0x20 && c != '\t' && c != '\f' && c != 0x1a) || c == 0x7f) {
            refuse_line(line, "this is a binary file", "a text file");
        }
        if (line > limits.lines || i >= limits.bytes)
            refuse_line(line, "the file is too long for " + std::string(limits.content),
                        std::to_string(limits.lines) + " lines and " + std::to_string(limits.bytes >> 20) +
                            " MB or less");
    }
    if (trimmed(bytes).empty()) refuse_line(1, "the file is empty", std::string(limits.content));
}

/// The text with blanks for no-break and thin ones, which documents and web pages have within "(k = 2)".
std::string with_plain_blanks(std::string text) {
    for (const std::string_view blank : {"\u00a0", "\u202f", "\u2009", "\u2007"}) {
        auto at = text.find(blank);
        if (at == std::string::npos) continue;
        std::string plain;
        plain.reserve(text.size());
        std::size_t done = 0;
        for (; at != std::string::npos; at = text.find(blank, done)) {
            plain.append(text, done, at - done) += ' ';
            done = at + blank.size();
        }
        text = plain.append(text, done);
    }
    return text;
}

/// Whether a line closes the quoted cell that the line before it leaves open: "v_in" above "[m/s]". It may
/// open the next one: above "[m/s]";"v_r".
bool joins(std::string_view before, std::string_view line) {
    if (std::ranges::count(before, '"') % 2 == 0 || line.find('"') == std::string_view::npos) return false;
    constexpr std::string_view separators = "\t;,";
    const auto open = before.rfind('"');
    const auto close = line.find('"');
    const char separator = separator_of(before);  // a ditto mark has one behind it, or nothing
    if (trimmed(before.substr(open + 1)).empty() || before.find(separator, open) != std::string_view::npos ||
        line.substr(0, close).find(separator) != std::string_view::npos)
        return false;
    return (open == 0 || separators.find(before[open - 1]) != std::string_view::npos) &&
           (close + 1 == line.size() || separators.find(line[close + 1]) != std::string_view::npos);
}

/// Removes a cell in quotes from the front of `text`, which begins behind the opening quote, and returns its
/// content.
std::string take_quoted(std::string_view& text, std::size_t line) {
    std::string cell;
    while (true) {
        const auto quote = text.find('"');
        if (quote == std::string_view::npos)
            refuse_line(line, "a quote is not closed", "quotes in pairs, each cell in one line");
        cell += text.substr(0, quote);
        text.remove_prefix(quote + 1);
        if (!text.starts_with('"')) return cell;
        cell += '"';
        text.remove_prefix(1);
    }
}

}  // namespace

std::string title_in_quotes(std::string_view title) {
    constexpr std::size_t longest = 400;
    std::string shown(whole_start(title, longest));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return '"' + shown + (title.size() > longest ? "...\"" : "\"");
}

std::string at_line(std::size_t number) {
    return "line " + std::to_string(number);
}

void refuse_line(std::size_t number, const std::string& problem, const std::string& allowed) {
    throw InputError(problem, allowed).at(at_line(number));
}

std::string at_cell(std::size_t line, std::size_t column) {
    return at_line(line) + ", cell " + std::to_string(column + 1);
}

TextLines::TextLines(std::string_view raw, const TextLimits& limits) : of_sheet_(limits.of_sheet) {
    const std::string decoded = is_utf16(raw) ? decoded_utf16(raw) : std::string();
    std::string_view bytes = decoded.empty() ? raw : decoded;
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    if (bytes.ends_with('\x1a')) bytes.remove_suffix(1);  // end-of-file mark of DOS editors
    check_bytes(bytes, limits);
    was_latin1_ = !is_utf8(bytes);
    text_ = with_plain_blanks(was_latin1_ ? from_latin1(bytes) : std::string(bytes));
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text_.size();) {
        const auto end = std::min(text_.find_first_of("\r\n", begin), text_.size());
        const bool crlf = text_.compare(end, 2, "\r\n") == 0;
        const std::string_view line = std::string_view(text_).substr(begin, end - begin);
        begin = std::min(text_.size(), end + (crlf ? 2 : 1));
        ++number;
        if (lines_.empty() || !joins(lines_.back().text, line)) {
            lines_.push_back({.number = number, .text = line});
            continue;
        }
        TextLine& before = lines_.back();  // a line break in a cell of the heading is a blank
        const auto at = static_cast<std::size_t>(before.text.data() - text_.data());
        std::fill(text_.begin() + static_cast<std::ptrdiff_t>(at + before.text.size()),
                  text_.begin() + static_cast<std::ptrdiff_t>(end - line.size()), ' ');
        before.text = std::string_view(text_).substr(at, end - at);
    }
}

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

bool take_units(TableRow& heading, const TableRow& line,
                const std::function<bool(std::string_view)>& is_unit) {
    TableRow with_units = heading;
    bool found = false;
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
        std::string_view unit = line.cells[i];
        if (unit.empty() || unit == "-") continue;
        const bool in_brackets =
            (unit.starts_with('[') && unit.ends_with(']')) || (unit.starts_with('(') && unit.ends_with(')'));
        if (in_brackets) unit = trimmed(unit.substr(1, unit.size() - 2));
        const bool is_number = unit.empty() || (!in_brackets && is_digit(unit.front()));
        if (is_number || i >= heading.cells.size() || heading.cells[i].ends_with(']') || !is_unit(unit))
            return false;
        with_units.cells[i] += " [" + std::string(unit) + "]";
        found = true;
    }
    if (found) heading = with_units;
    return found;
}

namespace {

/// Whether a text begins with the sign of a footnote and goes on: "* near the limit", "a) mean".
bool begins_with_sign(std::string_view text) {
    const auto sign = text.substr(0, text.find(' '));
    const bool is_sign =
        sign.size() <= 3 && (sign.ends_with(')') || sign.find_first_not_of('*') == std::string::npos ||
                             sign == "\u2020" || sign == "\u2021");
    return is_sign && !sign.empty() && sign.size() < text.size();
}

bool is_word_for_notes(std::string_view text) {
    static const WordLists words("remark columns", all_marks);
    return words.holds(trimmed(text));
}

/// Whether a text begins with such a word and a colon: "Note: measured at 40 kV, 40 mA".
bool announces_note(std::string_view text) {
    const auto colon = text.find(':');
    return colon != std::string_view::npos && is_word_for_notes(text.substr(0, colon));
}

}  // namespace

bool is_note(std::span<const std::string> cells) {
    const auto first = std::ranges::find_if(cells, [](const std::string& cell) { return !cell.empty(); });
    if (first == cells.end()) return false;
    if (std::any_of(first + 1, cells.end(), [](const std::string& cell) {
            return !cell.empty() && (read_number(cell, true) || says_no_number(cell));
        }))
        return false;
    const bool is_alone =
        std::all_of(first + 1, cells.end(), [](const std::string& cell) { return cell.empty(); });
    return begins_with_sign(*first) || (!is_alone && is_word_for_notes(*first)) || announces_note(*first);
}

std::vector<Finding> take_notes(std::vector<TextLine>& lines, std::size_t first, char separator,
                                std::string_view code) {
    std::size_t kept = lines.size();
    for (std::size_t i = lines.size(); i-- > first;) {
        std::size_t texts = 0;
        bool has_value = false;  // a number, or a word for none behind a name: "Lime;n.d."
        for_each_cell(lines[i], separator, [&](std::string_view cell, std::size_t) {
            if (cell.empty()) return;
            has_value = has_value || read_number(cell, true) || (texts > 0 && says_no_number(cell));
            ++texts;
        });
        const bool announced = announces_note(trimmed(lines[i].text)) ||
                               (!has_value && is_note(cut_row(lines[i], separator).cells));
        if (!announced && has_value) break;
        if (announced || (i > first && lines[i].number > lines[i - 1].number + 1)) kept = i;
    }
    std::vector<Finding> notes;
    for (std::size_t i = kept; i < lines.size(); ++i)
        notes.push_back({code, Severity::remark,
                         at_line(lines[i].number) +
                             " below the table is not read: " + title_in_quotes(trimmed(lines[i].text))});
    lines.resize(kept);
    return notes;
}

namespace {

/// Whether a line is a comment. One that begins with an error value of a spreadsheet ("#N/A", "#DIV/0!",
/// "#WERT!", "####"), with a number ("#1") or with the cell "#" is a row.
bool is_comment(std::string_view text) {
    if (!text.starts_with('#')) return false;
    const std::string_view word = text.substr(0, text.find_first_of(" \t;,"));
    if (word.size() == 1 && text.size() > 1 && text[1] != ' ') return false;
    if (word.size() > 1 && (is_digit(word[1]) || word[1] == '#')) return false;
    const bool shouts = std::none_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    return word != "#N/A" && word != "#NV" && !(shouts && (word.ends_with('!') || word.ends_with('?')));
}

/// Whether a comment names the columns of the row below it, which holds numbers.
bool is_heading_of(const TextLine& comment, const TextLine& row) try {
    const char separator = separator_of(row.text);
    const std::vector<std::string> names = cut_row(comment, separator).cells;
    const std::vector<std::string> cells = cut_row(row, separator).cells;
    const auto is_number = [](const std::string& cell) { return read_number(cell, true).has_value(); };
    return names.size() > 1 && names.size() == cells.size() && std::ranges::any_of(cells, is_number) &&
           !std::ranges::any_of(names, is_number);
} catch (const InputError&) {
    return false;  // an odd quote
}

}  // namespace

std::vector<TextLine> lines_with_content(const TextLines& file) {
    std::vector<TextLine> lines;
    std::optional<TextLine> comment;  // above the first line
    for (const TextLine& line : file.lines()) {
        const std::string_view text = trimmed(line.text);
        const bool has_content = text.find_first_not_of(" \t;,") != std::string_view::npos;
        if (!has_content || lower_case(text).starts_with("sep=")) continue;
        if (is_comment(text)) {
            comment = {line.number, trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())))};
            continue;
        }
        if (lines.empty() && comment && is_heading_of(*comment, line)) lines.push_back(*comment);
        lines.push_back(line);
    }
    return lines;
}

}  // namespace ashimpact
