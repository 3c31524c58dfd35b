// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

/// Look of a series: colour, dash and marker together, so that series differ in grey as well.
struct Look {
    std::size_t colour = 0;
    std::size_t dash = 0;
    std::size_t marker = 0;
    bool hollow = false;   ///< the marker is an outline
    bool neutral = false;  ///< in the colour of text instead
    bool thin = false;     ///< a fine line

    /// The look of the series at a position; beyond the palette colours repeat with other dashes.
    [[nodiscard]] static Look of(std::size_t index, bool hollow = false);
    /// In the colour of text, for what belongs to no law.
    [[nodiscard]] static Look plain(std::size_t marker, bool hollow = false);
};

/// CSS classes of colour, dash and fill of a look, for the class attribute of a group.
[[nodiscard]] std::string classes(const Look& look);

/// Style of drawings alone, light, with plain values that every program reads.
[[nodiscard]] std::string drawing_style();
/// The same with colours of a dark page under the media query of one.
[[nodiscard]] std::string page_drawing_style();

/// The markers, as SVG definitions that <use> refers to.
[[nodiscard]] std::string marker_definitions();
[[nodiscard]] std::string marker_name(std::size_t marker);

}  // namespace ashimpact::report
