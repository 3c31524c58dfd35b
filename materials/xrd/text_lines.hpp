#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ashimpact::xrd {

/// One line of a file, without its end, counted from one.
struct Line {
    std::size_t number = 0;
    std::string_view text;
};

/// A text file made uniform: UTF-8 without byte-order mark, lines without CR.
class TextLines {
  public:
    /// Errors: InputError with a line number for an empty, blank or binary file, for UTF-16, for a line of
    /// more than a megabyte and for more than 100,000 lines or longest_xrd_file.
    explicit TextLines(std::string_view bytes);

    TextLines(const TextLines&) = delete;
    TextLines& operator=(const TextLines&) = delete;

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] std::size_t last_line() const { return lines_.back().number; }

    /// Whether the bytes were no UTF-8 and were read as Latin-1.
    [[nodiscard]] bool was_latin1() const { return was_latin1_; }

  private:
    std::string text_;
    std::vector<Line> lines_;
    bool was_latin1_ = false;
};

/// "line N" for the place of an error.
[[nodiscard]] std::string at_line(std::size_t number);

}  // namespace ashimpact::xrd
