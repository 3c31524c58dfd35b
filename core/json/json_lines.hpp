// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace ashimpact {

/// Line numbers at which the values of a JSON text begin, by JSON pointer.
class JsonLines {
  public:
    /// `text` must be JSON that parses.
    explicit JsonLines(std::string_view text);

    /// The line of the value that a pointer names, or of the innermost recorded value that contains it.
    [[nodiscard]] std::size_t line_of(std::string pointer) const;

  private:
    void read_value(const std::string& pointer, std::size_t depth);
    void read_members(const std::string& pointer, std::size_t depth, char close);
    std::string read_string();
    char next();
    void skip(std::size_t bytes);

    std::string_view rest_;
    std::size_t line_ = 1;
    std::map<std::string, std::size_t> lines_;
};

}  // namespace ashimpact
