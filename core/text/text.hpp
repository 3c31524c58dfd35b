// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace ashimpact {

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The user's text for a one-line message: in quotes, cut off after 60 bytes, with blanks for control
/// characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The text with blanks for its line breaks.
[[nodiscard]] std::string on_one_line(std::string text);

/// ASCII letters in lower case; other bytes as they are.
[[nodiscard]] std::string lower_case(std::string_view text);

[[nodiscard]] inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The fewest digits that read back as the same number, "1e+05" rather than "100000" where that is shorter.
[[nodiscard]] std::string shortest(double value);

/// Removes a number in the C locale from the front of a text, as std::from_chars() reads it, which emscripten
/// has for integers only. Returns why there is none, std::errc{} if there is one.
std::errc take_decimal(std::string_view& text, double& value);

/// The whole text as a number in the C locale; none if it is anything else.
[[nodiscard]] std::optional<double> whole_decimal(std::string_view text);

/// Fewest insertions, deletions, replacements and swaps of neighbouring bytes that turn one word into the
/// other (optimal string alignment).
[[nodiscard]] std::size_t edit_distance(std::string_view from, std::string_view to);

/// Up to `count` candidates whose edit distance from the word is at most half of its length, ignoring case;
/// nearest first, equally near ones in their order.
[[nodiscard]] std::vector<std::string> nearest(std::string_view word,
                                               const std::vector<std::string>& candidates, std::size_t count);

/// `, did you mean "..."?` with the nearest candidate; empty if none is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// How to write a text that has commas between digits: `write "2.6 g/cm3"`; where one comma may as well part
/// thousands, `write "2600 kg/m3" or "2.600 kg/m3"`. Empty for a text without such a comma.
[[nodiscard]] std::string remedy_for_commas(std::string_view text);

/// Remedy for a number in quotes where a plain number is required: `, write 2.6 without quotes`.
/// Empty for any other text.
[[nodiscard]] std::string remedy_for_number_in_quotes(std::string_view text);

/// "a pressure", "an energy": the indefinite article by the first letter.
[[nodiscard]] std::string with_article(std::string_view noun);

/// The text cut at its numbers: words, number, words, ...
[[nodiscard]] std::vector<std::string> cut_at_numbers(std::string_view text);

/// The text with "#" for its numbers outside of quotes: what texts share that differ in numbers alone.
[[nodiscard]] std::string without_numbers(std::string_view text);

/// The words with ", " between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);
[[nodiscard]] std::string joined(std::span<const std::string_view> words);

/// The text with "?" for each control character, which could change the state of a terminal, except tabs and
/// line ends, and for each byte that belongs to no UTF-8 character.
[[nodiscard]] std::string without_controls(std::string_view text);

/// The text, such as a file name, with "..." for its middle if it is long.
[[nodiscard]] std::string shortened(const std::string& text);

/// The text as a word of a shell command, in single quotes if it needs them.
[[nodiscard]] std::string shell_word(const std::string& text);

/// "1 impact", "3 impacts": a number with its noun.
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// "line 4", "lines 4, 7, 9 and 12 more": numbers of lines for a message, which begins with @p word.
[[nodiscard]] std::string numbered(std::string_view word, const std::vector<std::size_t>& numbers);

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

/// Latin-1 bytes as UTF-8, and those that Windows puts between: "\u2013" for 0x96.
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

/// Name of a sample for comparing, as word_key() but with the marks of fractions: "FA +45", "FA <45" and "FA
/// 4.5" are not "FA 45"; a sign before a size, "FA -45", is "<".
[[nodiscard]] std::string sample_key(std::string_view name);

}  // namespace ashimpact
