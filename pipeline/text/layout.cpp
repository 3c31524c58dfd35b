#include "pipeline/text/layout.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace ashimpact {

namespace {

bool continues_a_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

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

}  // namespace

std::size_t output_width() {
    constexpr std::size_t narrowest = 40;
    winsize size{};
    if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return piped_width;
    return std::max<std::size_t>(narrowest, size.ws_col);
}

std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues_a_character(c); }));
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

std::string cut_to(const std::string& text, std::size_t width) {
    constexpr std::string_view dots = "...";
    if (width_of(text) <= width) return text;
    const std::size_t kept = width > dots.size() ? width - dots.size() : 0;
    std::size_t end = 0;
    for (std::size_t count = 0; end < text.size(); ++end)
        if (!continues_a_character(text[end]) && count++ == kept) break;
    return text.substr(0, end) + std::string(dots.substr(0, std::min(width, dots.size())));
}

}  // namespace ashimpact
