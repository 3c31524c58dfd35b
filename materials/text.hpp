#pragma once

#include <string>
#include <string_view>

namespace ashimpact {

/// The text without blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Piece of the user's text for a one-line message: in quotes, cut after 60 bytes, control characters
/// blanked.
[[nodiscard]] std::string quoted(std::string_view text);

/// ASCII letters in lower case; other bytes as they are.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Shortest decimal form that reads back as the same number.
[[nodiscard]] std::string shortest(double value);

}  // namespace ashimpact
