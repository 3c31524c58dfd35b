// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace ashimpact::report {

/// Text for HTML and SVG, element or attribute: what would be markup is escaped, control characters are left
/// out, and bytes that are not UTF-8 become U+FFFD. Whatever a name holds, it comes out as text.
[[nodiscard]] std::string escaped(std::string_view text);

/// A label of our own as SVG text: "v_in" gets a subscript. Not for names that users give.
[[nodiscard]] std::string subscripted(std::string_view label);

/// A coordinate with two decimals at most: "12.5".
[[nodiscard]] std::string pixels(double value);

/// An estimate of how wide a text is drawn, on the safe side [px].
[[nodiscard]] double text_width(std::string_view text, double font_size);

/// The text, cut with an ellipsis where it would be wider than @p most [px].
[[nodiscard]] std::string fitted(std::string_view text, double font_size, double most);

/// A user's name in SVG text, isolated so that right-to-left script does not reorder the text around it.
[[nodiscard]] std::string isolated(std::string_view name);

/// Bytes in base64.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Text for the data part of a data: address, every byte but letters, digits and a few marks as %XX.
[[nodiscard]] std::string percent_encoded(std::string_view text);

}  // namespace ashimpact::report
