// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

enum class Spacing { linear, logarithmic };

/// Ends of an axis.
struct Range {
    double from;
    double to;
};

inline constexpr double degree = std::numbers::pi / 180;  ///< [rad]

/// An axis; what is drawn along it comes in SI.
struct Axis {
    std::string label;   ///< "v_in"
    std::string unit{};  ///< as shown, "nm"; empty for pure numbers
    double scale = 1;    ///< of one shown unit [SI unit]
    Spacing spacing = Spacing::linear;
    bool from_zero = false;              ///< linear: begins at 0 where the data allow it
    std::optional<double> from{}, to{};  ///< fixed ends [SI]; none: where the data end
};

struct Point {
    double x;
    double y;
};

/// One point with error bars; 0 draws none.
struct Mark {
    double x;
    double y;
    double x_error = 0;
    double y_error = 0;
};

/// Line, marks and band of one thing.
struct Series {
    std::string name;    ///< for the readout
    std::string legend;  ///< of the legend; one entry for all series of the same; empty: none
    Look look{};
    std::vector<Point> line{};  ///< a point that is not finite interrupts it
    std::vector<Mark> marks{};
    std::vector<Point> band{};  ///< a closed polygon behind the line
    bool area = false;          ///< the band is a part of a whole, not an uncertainty
};

/// A range of x in which something holds.
struct Region {
    double from;
    double to;
    std::string label{};
};

/// A vertical line, with a band of that interval behind it.
struct Rule {
    double x;
    std::string label{};
    Look look{};
    std::optional<Range> interval{};
};

/// Curves and points over two axes.
struct XyPanel {
    std::string title;
    Axis x;
    Axis y;
    std::vector<Region> regions{};
    std::vector<Rule> rules{};
    std::vector<Series> series{};
};

/// A part of a stacked bar, an interval or a mark in a row.
struct RowItem {
    enum class Kind { bar, interval, mark };
    Kind kind;
    double from;  ///< of bars and intervals
    double to;    ///< of bars and intervals; the place of a mark
    Look look{};
    std::string name;      ///< for the readout and, in a bar with room, written inside
    std::string legend{};  ///< as in Series
    double shift = 0;      ///< below the middle of the row [px]
};

struct Row {
    std::string label;
    std::vector<RowItem> items{};
    bool heading = false;  ///< a label alone
};

/// Rows of bars, intervals and marks over one axis.
struct RowPanel {
    std::string title;
    Axis x;
    std::vector<Row> rows{};
};

using Panel = std::variant<XyPanel, RowPanel>;

/// Place of a panel in its drawing [px].
struct Box {
    double left;
    double top;
    double width;
    double height;
};

/// A panel as SVG.
[[nodiscard]] std::string drawn(const XyPanel& panel, const Box& box);
[[nodiscard]] std::string drawn(const RowPanel& panel, const Box& box);

/// Height a panel needs at a width [px].
[[nodiscard]] double height_of(const RowPanel& panel);

/// Gives all panels the same ends on both axes, or on one.
void share_axes(std::vector<Panel>& panels, bool x, bool y);

}  // namespace ashimpact::report
