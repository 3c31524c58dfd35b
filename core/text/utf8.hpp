// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace ashimpact {

/// One character of a UTF-8 text, or one byte that belongs to none.
struct Character {
    std::string_view bytes;
    char32_t code_point = 0xfffd;  ///< U+FFFD for a byte that belongs to no character
    bool valid = false;

    /// True for control characters, except tabs and line ends.
    [[nodiscard]] bool is_control() const;
};

/// The first character of a text that is not empty. Overlong forms and surrogates are not valid.
[[nodiscard]] Character first_character(std::string_view text);

/// Calls @p each with every character of a text.
template <class Each>
void for_each_character(std::string_view text, Each&& each) {
    while (!text.empty()) {
        const Character character = first_character(text);
        each(character);
        text.remove_prefix(character.bytes.size());
    }
}

[[nodiscard]] bool is_utf8(std::string_view text);
[[nodiscard]] bool is_ascii(std::string_view text);

/// Number of characters of a UTF-8 text: its width in a terminal.
[[nodiscard]] std::size_t width_of(std::string_view text);

/// The first @p count characters, or all if there are fewer.
[[nodiscard]] std::string_view first_characters(std::string_view text, std::size_t count);

/// The longest beginning, or end, of at most @p most bytes that cuts no character.
[[nodiscard]] std::string_view whole_start(std::string_view text, std::size_t most);
[[nodiscard]] std::string_view whole_end(std::string_view text, std::size_t most);

/// Latin-1 bytes as UTF-8.
[[nodiscard]] std::string from_latin1(std::string_view bytes);

/// The text with each first of a pair replaced by its second; earlier pairs win.
using Replacements = std::span<const std::pair<std::string_view, std::string_view>>;
[[nodiscard]] std::string replaced(std::string_view text, Replacements pairs);

/// The text in ASCII as people spell it without a special keyboard: "ü" is "ue", "ß" "ss", "é" "e", "σ"
/// "sigma", "Σ" "sum", "±" "+-", "₂" "2". Characters that are not in the table stay.
[[nodiscard]] std::string transliterated(std::string_view text);

/// The text as word lists hold it, so that spellings do not matter: transliterated, in lower case, only
/// letters and digits, other characters than ASCII and those of @p kept. "v_{rück}" is "vrueck".
[[nodiscard]] std::string word_key(std::string_view text, std::string_view kept = {});

}  // namespace ashimpact
