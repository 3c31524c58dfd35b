// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/present/report/drawing/panel.hpp"

namespace ashimpact::report {

inline constexpr double tick_size = 11;      ///< font size of ticks [px]
inline constexpr double subscript_size = 9;  ///< of subscripts and the smallest titles [px]
inline constexpr double label_size = 12;     ///< font size of labels and titles [px]
inline constexpr double title_size =
    13.5;  ///< of a bold title, whose letters are wider, as a plain font size [px]
inline constexpr double title_height = 20;  ///< [px]
inline constexpr double axis_height = 36;   ///< ticks and label below a plot [px]

struct Tick {
    double value;
    std::string label;
};

/// Maps numbers to pixels along an axis.
struct Scale {
    Spacing spacing;
    Range values;  ///< from < to, both > 0 where logarithmic
    Range at;      ///< pixels of the two ends

    [[nodiscard]] double operator()(double value) const;
    /// Round numbers within the range, at most @p most (but two at least), with labels.
    [[nodiscard]] std::vector<Tick> ticks(int most) const;
};

/// Grows an empty or reversed range so that it can be an axis, and keeps a logarithmic one above 0.
[[nodiscard]] Range drawable(Range range, Spacing spacing);

/// The range as that of an axis, with a margin of that share at either end that is not zero.
[[nodiscard]] Range with_margin(Range extent, const Axis& axis, double share);

/// A number as a label: "0.25", "2e-05" as "2·10⁻⁵".
[[nodiscard]] std::string number_label(double value);

/// "v_in [m/s]" as SVG text.
[[nodiscard]] std::string axis_label(const Axis& axis);

/// The scale of an axis for data in SI between two pixels; @p round grows the ends by a margin.
[[nodiscard]] Scale scale_of(const Axis& axis, Range extent, Range at);

/// Grid, ticks and label of a horizontal axis below @p plot.
[[nodiscard]] std::string horizontal_axis(const Axis& axis, const Scale& scale, const Box& plot);
/// Grid and ticks of a vertical axis left of @p plot.
[[nodiscard]] std::string vertical_grid(const Scale& scale, const Box& plot);
/// Room that the tick labels of a vertical axis need [px].
[[nodiscard]] double tick_width(const Axis& axis, Range extent, double height);

/// What the readout needs to turn pixels into numbers: data attributes of an axis, named @p which.
[[nodiscard]] std::string axis_data(char which, const Axis& axis, const Scale& scale);

/// A title that begins at @p x, further left where it would reach beyond @p end, and is cut where it would
/// not fit from @p least on.
struct TitlePlace {
    double least;
    double x;
    double end;
    double y;
};
[[nodiscard]] std::string title_text(const std::string& title, const TitlePlace& place);

}  // namespace ashimpact::report
