// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace ashimpact::report {

/// Look of a series: colour, dash and marker together, so that series differ in grey as well.
struct Look {
    std::size_t colour = 0;
    std::size_t dash = 0;
    std::size_t marker = 0;
    bool hollow = false;   ///< the marker is an outline
    bool neutral = false;  ///< in the colour of text instead
    bool thin = false;     ///< a fine line

    /// The look of the series at a position; beyond the palette colours repeat, with other dashes and
    /// markers.
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
