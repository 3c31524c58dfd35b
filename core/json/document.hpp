// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/text/error.hpp"

namespace ashimpact {

using Json = nlohmann::ordered_json;

/// A JSON pointer one level down, with "~" and "/" in the key escaped.
[[nodiscard]] std::string child_pointer(const std::string& pointer, std::string_view key);
[[nodiscard]] std::string child_pointer(const std::string& pointer, std::size_t index);

/// Parses the user's JSON, without its comments: `// ...`, `/* ... */`, and members whose key begins with
/// "//". Stricter than the library: a repeated key in one object, more than 64 levels, a number out of range
/// and text after the end are errors too. Errors: InputError at "line N, column M" or at the JSON pointer.
[[nodiscard]] Json parse_json(std::string_view text);

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

enum class Digits {
    shortest,   ///< the fewest digits that read back as the same number
    seventeen,  ///< 17 significant digits
};

/// Writes a document with each short object or array on one line, which keeps quantities and columns
/// readable. The same document gives the same bytes. Ends with a newline.
/// @throws std::logic_error for a number that is not finite, which no result may contain
[[nodiscard]] std::string write_json(const Json& document, Digits digits = Digits::shortest);

/// What parse_json() makes of write_json(document): whole numbers become integers.
[[nodiscard]] Json as_read_back(Json document);

}  // namespace ashimpact
