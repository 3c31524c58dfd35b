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

/// The figure as one SVG element: the wide form is for a page or two columns, the narrow one for a telephone
/// or one column.
/// @param style "" in a page, whose style covers it; else the style and markers that make a file of its own
[[nodiscard]] std::string svg_of(const Figure& figure, Width form, const std::string& style = {});

/// Whether the text of an SVG file has our mark.
[[nodiscard]] bool is_own_svg(std::string_view svg);

/// The numbers as CSV, with seven digits; the artifacts have all of them.
[[nodiscard]] std::string csv_of(const NumberTable& table);

/// Kinds of figure files, by their endings.
enum class FigureFormat { svg, pdf, png };

/// The format of a file name's ending. @throws InputError naming the allowed ones
[[nodiscard]] FigureFormat format_of(const std::filesystem::path& file);

/// Refuses a format that needs rsvg-convert where that program is missing. @throws InputError saying how to
/// get it
void require_converter(FigureFormat format);

/// The bytes of a figure in a format: SVG by us, 170 mm or 85 mm wide and marked as ours; PDF (vector, fonts
/// embedded) and PNG (600 dots an inch) by rsvg-convert of librsvg. The same figure gives the same bytes with
/// the same version of that program.
/// @throws InputError where it is missing or fails
[[nodiscard]] std::string figure_bytes(const Figure& figure, Width width, FigureFormat format);

}  // namespace ashimpact::report
