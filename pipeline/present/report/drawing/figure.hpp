// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/present/report/drawing/panel.hpp"

namespace ashimpact::report {

/// A cell of a table: a number in SI or text.
using Cell = std::variant<double, std::string>;

/// The numbers behind a figure.
struct NumberTable {
    std::vector<std::string> columns{};  ///< with their units, "velocity [m/s]"
    std::vector<std::vector<Cell>> rows{};
    int shown_every = 1;  ///< row in the page; the CSV has all
};

/// A figure of a report: panels, title, caption and numbers.
struct Figure {
    std::string id;             ///< "restitution": link target and name for `ashimpact figure`
    std::string title;          ///< a heading
    std::string counterpart{};  ///< "Figure 5 of Dong et al. 2013"; empty: none
    std::string caption{};      ///< explains what is drawn
    std::vector<Panel> panels{};
    NumberTable numbers{};
    int columns = 3;            ///< of panels, in the wide form
    int narrow_columns = 1;     ///< in the narrow form
    double panel_height = 230;  ///< of a panel over two axes [px]
};

enum class Width { wide, narrow };

/// The figure as one SVG element, wide for a page or two columns, narrow for a telephone or one.
/// @param style of a file of its own, with markers; empty in a page, whose style covers it
[[nodiscard]] std::string svg_of(const Figure& figure, Width form, const std::string& style = {});

/// Whether the text of an SVG file has our mark.
[[nodiscard]] bool is_own_svg(std::string_view svg);

/// The numbers as CSV, with seven digits; the artifacts have all of them.
[[nodiscard]] std::string csv_of(const NumberTable& table);

/// Kinds of figure files, by their endings.
enum class FigureFormat { svg, pdf, png };

/// The format of a file name's ending. @throws InputError naming the allowed ones
[[nodiscard]] FigureFormat format_of(const std::filesystem::path& file);

/// @throws InputError if a format needs rsvg-convert and that program is missing
void require_converter(FigureFormat format);

/// The bytes of a figure in a format: SVG by us, 170 mm or 85 mm wide and marked as ours; PDF (vector, fonts
/// embedded) and PNG (600 dots an inch) by rsvg-convert, the same bytes with the same version of it.
/// @throws InputError where it is missing or fails
[[nodiscard]] std::string figure_bytes(const Figure& figure, Width width, FigureFormat format);

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

/// A title begins at x, further left where it would reach beyond end, and is cut if too long from least on.
struct TitlePlace {
    double least;
    double x;
    double end;
    double y;
};
[[nodiscard]] std::string title_text(const std::string& title, const TitlePlace& place);

}  // namespace ashimpact::report
