// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/text_lines.hpp"

#include <algorithm>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/text/utf8.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;

/// Refuses a file that cannot be a text, before anything is copied.
void check_bytes(std::string_view bytes, const TextLimits& limits) {
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        throw InputError("this is UTF-16", "UTF-8, ASCII or Latin-1 text").at(at_line(1));
    std::size_t line_start = 0;
    std::size_t line = 1;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const unsigned char c = static_cast<unsigned char>(bytes[i]);
        if (c == '\n' || c == '\r') {
            line_start = i + 1;
            const bool crlf = c == '\r' && bytes.substr(i + 1).starts_with('\n');
            line += crlf ? 0 : 1;
        } else if (i - line_start >= longest_line) {
            throw InputError("the line is longer than a megabyte", "a text file with lines")
                .at(at_line(line));
        } else if ((c < 0x20 && c != '\t' && c != '\f' && c != 0x1a) || c == 0x7f) {
            throw InputError("this is a binary file", "a text file").at(at_line(line));
        }
        if (line > limits.lines || i >= limits.bytes)
            throw InputError("the file is too long for " + std::string(limits.content),
                             std::to_string(limits.lines) + " lines and " +
                                 std::to_string(limits.bytes >> 20) + " MB or less")
                .at(at_line(line));
    }
    if (trimmed(bytes).empty())
        throw InputError("the file is empty", std::string(limits.content)).at(at_line(1));
}

}  // namespace

std::string at_line(std::size_t number) {
    return "line " + std::to_string(number);
}

std::string at_cell(std::size_t line, std::size_t column) {
    return at_line(line) + ", cell " + std::to_string(column + 1);
}

TextLines::TextLines(std::string_view bytes, const TextLimits& limits) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    if (bytes.ends_with('\x1a')) bytes.remove_suffix(1);  // end-of-file mark of DOS editors
    check_bytes(bytes, limits);
    was_latin1_ = !is_utf8(bytes);
    text_ = was_latin1_ ? from_latin1(bytes) : std::string(bytes);
    std::string_view rest = text_;
    while (!rest.empty()) {
        const auto end = std::min(rest.find_first_of("\r\n"), rest.size());
        lines_.push_back({.number = lines_.size() + 1, .text = rest.substr(0, end)});
        const bool crlf = rest.substr(end).starts_with("\r\n");
        rest.remove_prefix(std::min(rest.size(), end + (crlf ? 2 : 1)));
    }
}

}  // namespace ashimpact
