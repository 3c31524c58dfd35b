#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ashimpact {

/// JSON with its keys in the order of the file.
using Json = nlohmann::ordered_json;

/// Reads a JSON text.
/// @throws InputError whose place is the line and column where the text is broken, or the JSON pointer of a
/// duplicate key or of a number too large
[[nodiscard]] Json parse_json(std::string_view text);

/// Whether a key holds a comment: it begins with "//".
[[nodiscard]] bool is_comment(std::string_view key);

/// The document without its comments, at any depth.
[[nodiscard]] Json without_comments(const Json& document);

/// A JSON pointer one level down, with "~" and "/" in the key escaped.
[[nodiscard]] std::string child_pointer(const std::string& pointer, std::string_view key);
[[nodiscard]] std::string child_pointer(const std::string& pointer, std::size_t index);

}  // namespace ashimpact
