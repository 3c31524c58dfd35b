#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ashimpact {

/// The text without blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Piece of the user's text for a one-line message: in quotes, cut after 60 bytes, control characters
/// blanked.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The text with blanks for its line breaks.
[[nodiscard]] std::string on_one_line(std::string text);

/// ASCII letters in lower case; other bytes as they are.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Shortest decimal form that reads back as the same number.
[[nodiscard]] std::string shortest(double value);

/// Fewest insertions, deletions and replacements of bytes that turn one word into the other (Levenshtein).
[[nodiscard]] std::size_t edit_distance(std::string_view from, std::string_view to);

/// Up to `count` of the candidates that are near to the word (edit distance, case ignored, at most half of
/// its length), nearest first, equally near ones in their order.
[[nodiscard]] std::vector<std::string> nearest(std::string_view word,
                                               const std::vector<std::string>& candidates, std::size_t count);

/// `, did you mean "..."?` with the nearest candidate; empty where none is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "a pressure", "an energy": the indefinite article by the first letter.
[[nodiscard]] std::string with_article(std::string_view noun);

/// The words with ", " between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);
[[nodiscard]] std::string joined(std::span<const std::string_view> words);

/// The text with "?" for each control character, of one byte or in UTF-8, but tabs and line ends, which a
/// terminal would obey, and for each byte that is part of no UTF-8 character.
[[nodiscard]] std::string without_controls(std::string_view text);

/// Bytes of the UTF-8 character with which a text begins; 0 if it begins with none. @param text not empty
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// A long text, such as a file name, with "..." for its middle.
[[nodiscard]] std::string shortened(const std::string& text);

/// The text as a word of a shell command, in single quotes if it needs them.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace ashimpact
