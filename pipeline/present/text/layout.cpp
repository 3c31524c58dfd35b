// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/layout.hpp"

#include <algorithm>
#include <vector>

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

}  // namespace ashimpact
