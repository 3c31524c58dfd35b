#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "materials/base/error.hpp"

namespace ashimpact {

using Json = nlohmann::ordered_json;

/// Whether a key holds a comment: it begins with "//".
[[nodiscard]] bool is_comment(std::string_view key);

/// A JSON pointer one level down, with "~" and "/" in the key escaped.
[[nodiscard]] std::string child_pointer(const std::string& pointer, std::string_view key);
[[nodiscard]] std::string child_pointer(const std::string& pointer, std::size_t index);

/// Parses the user's JSON, stricter than the library: a key twice in one object (comments apart), more than
/// 64 levels, a number out of range and text after the end are errors, and so is what is no JSON. Errors:
/// InputError at "line N, column M" or at the JSON pointer.
[[nodiscard]] Json parse_json(std::string_view text);

/// Throws InputError unless `node` is an object whose keys are all in `allowed`; names the nearest allowed
/// key.
void require_keys(const Json& node, std::initializer_list<std::string_view> allowed);

/// The member `key` of an object. Errors: InputError if it is missing.
[[nodiscard]] const Json& required(const Json& node, std::string_view key);

/// A string, number or list of strings, checked. Errors: InputError without a place.
[[nodiscard]] std::string as_string(const Json& node);
[[nodiscard]] double as_number(const Json& node);
[[nodiscard]] const Json& as_array(const Json& node);
[[nodiscard]] std::vector<std::string> as_strings(const Json& node);

/// Runs `read` and puts `place` in front of the place of an InputError it throws.
template <class Read>
decltype(auto) at_place(const std::string& place, Read&& read) {
    try {
        return std::forward<Read>(read)();
    } catch (const InputError& error) {
        throw error.at(place);
    }
}

/// Runs `read` and puts the name of a file in front of the place of an InputError it throws.
template <class Read>
decltype(auto) in_file(const std::string& file, Read&& read) {
    try {
        return std::forward<Read>(read)();
    } catch (const InputError& error) {
        throw error.in_file(file);
    }
}

/// Reads member `key` with `read(member)`, errors placed at "/key"; nothing if the member is not there.
template <class Read>
auto optional_member(const Json& node, const std::string& key, Read&& read)
    -> std::optional<decltype(read(node))> {
    if (!node.contains(key)) return std::nullopt;
    return at_place("/" + key, [&] { return read(node.at(key)); });
}

/// Reads member `key` with `read(member)`, errors placed at "/key". Errors: InputError if it is missing.
template <class Read>
auto required_member(const Json& node, const std::string& key, Read&& read) {
    const Json& member = required(node, key);
    return at_place("/" + key, [&] { return read(member); });
}

}  // namespace ashimpact
