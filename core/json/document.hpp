// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace ashimpact
