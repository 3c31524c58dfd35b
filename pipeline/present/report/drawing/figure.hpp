// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    std::vector<std::string> columns;  ///< with their units, "velocity [m/s]"
    std::vector<std::vector<Cell>> rows{};
    int shown_every = 1;  ///< row in the page; the CSV has all
};

/// A figure of a report: panels, title, caption and numbers.
struct Figure {
    std::string id;           ///< "restitution": link target and name for `ashimpact figure`
    std::string title;        ///< a heading
    std::string counterpart;  ///< "Figure 5 of Dong et al. 2013"; empty: none
    std::string caption;      ///< explains what is drawn
    std::vector<Panel> panels;
    NumberTable numbers;
    int columns = 3;            ///< of panels, in the wide form
    int narrow_columns = 1;     ///< in the narrow form
    double panel_height = 230;  ///< of a panel over two axes [px]
};

enum class Width { wide, narrow };

/// The figure as one SVG element: the wide form is for a page or two columns, the narrow one for a telephone
/// or one column.
/// @param style "" in a page, whose style covers it; else the style and markers that make a file of its own
[[nodiscard]] std::string svg_of(const Figure& figure, Width form, const std::string& style = {});

/// A complete SVG file, 170 mm or 85 mm wide, marked as ours.
[[nodiscard]] std::string svg_file(const Figure& figure, Width width);

/// Whether the text of an SVG file has our mark.
[[nodiscard]] bool is_own_svg(std::string_view svg);

/// The numbers as CSV, with seven digits; the artifacts have all of them.
[[nodiscard]] std::string csv_of(const NumberTable& table);

}  // namespace ashimpact::report
