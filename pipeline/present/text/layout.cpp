// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/layout.hpp"

#include <algorithm>
#include <numeric>

#include <sys/ioctl.h>
#include <unistd.h>

namespace ashimpact {

namespace {

std::string wrapped_line(std::string_view line, std::size_t width, std::size_t hanging) {
    const std::size_t first_word = std::min(line.find_first_not_of(' '), line.size());
    const std::string margin(first_word + hanging, ' ');
    std::string out(line.substr(0, first_word));
    std::size_t column = first_word;
    bool line_has_words = false;
    for (std::size_t begin = first_word; begin < line.size();) {
        // A word with the blanks before it.
        const std::size_t word = std::min(line.find_first_not_of(' ', begin), line.size());
        const std::size_t end = std::min(line.find(' ', word), line.size());
        const std::size_t length = width_of(line.substr(word, end - word));
        if (line_has_words && column + (word - begin) + length > width) {
            out += '\n' + margin;
            column = margin.size();
        } else {
            out += line.substr(begin, word - begin);
            column += word - begin;
        }
        out += line.substr(word, end - word);
        column += length;
        line_has_words = true;
        begin = end;
    }
    return out;
}

/// The words of a command, a quoted one as one word.
std::vector<std::string> shell_words(const std::string& command) {
    std::vector<std::string> words(1);
    char quote = 0;
    for (const char c : command) {
        if (c == ' ' && quote == 0) {
            if (!words.back().empty()) words.emplace_back();
            continue;
        }
        if (quote == 0 && (c == '"' || c == '\''))
            quote = c;
        else if (c == quote)
            quote = 0;
        words.back() += c;
    }
    return words;
}

/// Columns of the terminal that a descriptor leads to, else piped_width.
std::size_t width_of_terminal(int descriptor) {
    constexpr std::size_t narrowest = 40;
    winsize size{};
    if (isatty(descriptor) == 0 || ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return piped_width;
    return std::max<std::size_t>(narrowest, size.ws_col);
}

constexpr std::size_t gap = 2;
constexpr std::size_t narrowest_key = 16;    ///< to which a column that names rows is cut
constexpr std::size_t narrowest_value = 20;  ///< of a list: where less is left, the value goes below its name

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

/// Characters of the first columns, with the gaps between them.
std::size_t span_of(const std::vector<std::size_t>& widths, std::size_t columns) {
    std::size_t taken = columns > 1 ? (columns - 1) * gap : 0;
    for (std::size_t i = 0; i < columns; ++i) taken += widths[i];
    return taken;
}

/// Cuts the columns that name rows until @p room is left beside them, or they are as narrow as may be.
void narrow_keys(std::vector<std::size_t>& widths, std::size_t keys, std::size_t width, std::size_t room) {
    for (std::size_t i = 0; i < keys; ++i) {
        const std::size_t taken = span_of(widths, keys) + gap;
        if (taken + room <= width) return;
        const std::size_t excess = taken + room - width;
        widths[i] = std::max(std::min(widths[i], narrowest_key), widths[i] - std::min(widths[i], excess));
    }
}

}  // namespace

std::size_t output_width() {
    return width_of_terminal(STDOUT_FILENO);
}

std::size_t message_width() {
    return width_of_terminal(STDERR_FILENO);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t hanging) {
    std::string out;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        out += width_of(line) <= width ? std::string(line) : wrapped_line(line, width, hanging);
        if (end < text.size()) out += '\n';
        begin = end + 1;
    }
    return out;
}

std::string wrapped_command(const std::string& line, std::size_t width) {
    if (width_of(line) <= width) return line;
    constexpr std::string_view backslash = " \\";
    const std::size_t indent = line.find_first_not_of(' ');
    std::string out(indent, ' ');
    std::size_t column = indent;
    const auto words = shell_words(line.substr(indent));
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::string piece = words[i];
        if (piece.starts_with("-") && i + 1 < words.size() && !words[i + 1].starts_with("-"))
            piece += " " + words[++i];
        const bool breaks = column > indent && column + 1 + width_of(piece) + backslash.size() > width;
        if (breaks) {
            column = indent + 2;
            out += std::string(backslash) + '\n' + std::string(column, ' ');
        } else if (column > indent) {
            out += ' ';
            ++column;
        }
        out += piece;
        column += width_of(piece);
    }
    return out;
}

std::string cut_to(const std::string& text, std::size_t width) {
    constexpr std::string_view dots = "...";
    if (width_of(text) <= width) return text;
    const std::size_t kept = width > dots.size() ? width - dots.size() : 0;
    return std::string(first_characters(text, kept)) +
           std::string(dots.substr(0, std::min(width, dots.size())));
}

std::vector<std::size_t> TextTable::column_widths() const {
    std::vector<std::size_t> widths(rows_.front().size());
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < std::min(row.size(), widths.size()); ++i)
            widths[i] = std::max(widths[i], width_of(row[i]));
    return widths;
}

void TextTable::drop_empty_columns() {
    const auto is_empty = [&](std::size_t column) {
        return std::all_of(rows_.begin() + 1, rows_.end(), [&](const auto& row) {
            return column >= row.size() || row[column].empty() || row[column] == "-";
        });
    };
    for (std::size_t column = rows_.front().size(); column-- > keys_;) {
        if (!is_empty(column)) continue;
        for (auto& row : rows_)
            if (column < row.size()) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    }
}

std::string TextTable::block_text(const std::vector<std::size_t>& columns,
                                  const std::vector<std::size_t>& widths, std::size_t indent) const {
    const std::string margin(indent, ' ');
    std::string out;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::string line = margin;
        for (const std::size_t i : columns) {
            const std::string cell = i < rows_[r].size() ? cut_to(rows_[r][i], widths[i]) : std::string{};
            const std::string blanks(widths[i] - width_of(cell), ' ');
            if (i != columns.front()) line += std::string(gap, ' ');
            line += i < keys_ ? cell + blanks : blanks + cell;
        }
        const std::size_t length = width_of(line);
        out += without_trailing_blanks(std::move(line)) + "\n";
        if (r == 0) out += margin + std::string(length - indent, '-') + "\n";
    }
    return out;
}

std::string TextTable::text(std::size_t indent, std::size_t width) const {
    std::vector<std::size_t> widths = column_widths();
    const std::size_t keys = std::min(keys_, widths.size());
    width = std::max(width, indent + narrowest_value) - indent;
    const std::size_t whole = span_of(widths, widths.size());
    // Names are cut so that the table stays in one piece, else as far as they have to be.
    if (whole > width) {
        std::vector<std::size_t> cut = widths;
        narrow_keys(cut, keys, width, whole - span_of(widths, keys) - gap);
        if (span_of(cut, cut.size()) > width) {
            std::size_t widest = 0;
            for (std::size_t i = keys; i < widths.size(); ++i) widest = std::max(widest, widths[i]);
            narrow_keys(cut = widths, keys, width, std::min(widest, width / 2));
        }
        widths = std::move(cut);
    }
    const std::size_t taken = span_of(widths, keys);
    std::vector<std::size_t> names(keys);
    std::iota(names.begin(), names.end(), std::size_t{0});
    std::string out;
    std::vector<std::size_t> columns = names;
    std::size_t line = taken;
    for (std::size_t i = keys; i < widths.size(); ++i) {
        widths[i] = std::min(widths[i], width - std::min(width, taken + gap));
        if (columns.size() > keys && line + gap + widths[i] > width) {
            out += block_text(columns, widths, indent) + "\n";
            columns = names;
            line = taken;
        }
        columns.push_back(i);
        line += gap + widths[i];
    }
    return out + block_text(columns, widths, indent);
}

void TextList::add(const std::string& name, const std::string& value) {
    rows_.emplace_back(name, value);
}

std::string TextList::text(std::size_t indent, std::size_t width) const {
    std::size_t longest = 0;
    for (const auto& [name, value] : rows_) longest = std::max(longest, width_of(name));
    const std::size_t column = indent + longest + gap;
    const bool fits = column + narrowest_value <= width;
    std::string out;
    for (const auto& [name, value] : rows_) {
        std::string line(indent, ' ');
        line += name;
        line += std::string(longest - width_of(name) + gap, ' ');
        line += value;
        const std::size_t own_indent = std::min(line.find_first_not_of(' '), column);
        out += without_trailing_blanks(wrapped(line, width, fits ? column - own_indent : 2));
        out += '\n';
    }
    return out;
}

}  // namespace ashimpact
