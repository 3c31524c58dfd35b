// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Turns data in SI into pixels of a panel, held within its frame.
struct Frame {
    const Scale& x;
    const Scale& y;
    double x_unit;
    double y_unit;

    [[nodiscard]] double across(double value) const { return held(x(value / x_unit), x.at); }
    [[nodiscard]] double up(double value) const { return held(y(value / y_unit), y.at); }
    [[nodiscard]] bool holds(const Point& point) const {
        return std::isfinite(point.x) && std::isfinite(point.y) && within(point.x / x_unit, x) &&
               within(point.y / y_unit, y);
    }

  private:
    static double held(double pixel, const Range& at) {
        if (std::isnan(pixel)) return at.from;
        return std::clamp(pixel, std::min(at.from, at.to), std::max(at.from, at.to));
    }
    static bool within(double value, const Scale& scale) {
        const Range& range = scale.values;
        const double slack = 1e-9 * (range.to - range.from);
        return value >= range.from - slack && value <= range.to + slack;
    }
};

/// The smallest range with all values that are finite.
struct Extent {
    Range range{infinity, -infinity};

    void take(double value) {
        if (std::isfinite(value)) range = {std::min(range.from, value), std::max(range.to, value)};
    }
};

std::string frame_of(const Box& plot) {
    return fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></g>",
                       pixels(plot.left), pixels(plot.top), pixels(plot.width), pixels(plot.height));
}

/// Whether all points [px] between two lie within a twentieth of a pixel of the line that joins them.
bool is_straight(const std::vector<Point>& all, std::size_t first, std::size_t last) {
    const double dx = all[last].x - all[first].x;
    const double dy = all[last].y - all[first].y;
    const double length = std::hypot(dx, dy);
    for (std::size_t i = first + 1; i < last; ++i) {
        const double across = dx * (all[i].y - all[first].y) - dy * (all[i].x - all[first].x);
        if (!(std::abs(across) <= 0.05 * length)) return false;
    }
    return true;
}

/// A pixel of a line: a tenth is finer than anyone sees.
std::string tenths(double pixel) {
    return pixels(std::round(10 * pixel) / 10);
}

/// One uninterrupted line, without the vertices that nobody would miss.
std::string polyline(const std::vector<Point>& all) {
    std::string path;
    for (std::size_t i = 0; i < all.size();) {
        path += fmt::format("{}{} {}", i == 0 ? "M" : "L", tenths(all[i].x), tenths(all[i].y));
        std::size_t next = i + 1;
        while (next + 1 < all.size() && is_straight(all, i, next + 1)) ++next;
        i = next;
    }
    return path;
}

std::string path_of(const std::vector<Point>& points, const Frame& frame) {
    std::string path;
    std::vector<Point> piece;
    const auto finish = [&] {
        if (piece.size() > 1) path += polyline(piece);
        piece.clear();
    };
    for (const Point& point : points)
        if (frame.holds(point))
            piece.push_back({frame.across(point.x), frame.up(point.y)});
        else
            finish();
    finish();
    return path;
}

std::string band_of(const Series& series, const Frame& frame) {
    std::vector<Point> outline;
    for (const Point& point : series.band)
        if (std::isfinite(point.x) && std::isfinite(point.y))
            outline.push_back({frame.across(point.x), frame.up(point.y)});
    if (outline.size() < 3) return {};
    return fmt::format("<path class=\"{}\" d=\"{}Z\"/>", series.area ? "area" : "band", polyline(outline));
}

std::string marks_of(const Series& series, const Frame& frame) {
    std::string bars;
    std::string marks;
    for (const Mark& mark : series.marks) {
        if (!frame.holds({mark.x, mark.y})) continue;
        const std::string x = pixels(frame.across(mark.x));
        const std::string y = pixels(frame.up(mark.y));
        if (mark.y_error > 0)
            bars += fmt::format("M{} {}V{}", x, pixels(frame.up(mark.y - mark.y_error)),
                                pixels(frame.up(mark.y + mark.y_error)));
        if (mark.x_error > 0)
            bars += fmt::format("M{} {}H{}", pixels(frame.across(mark.x - mark.x_error)), y,
                                pixels(frame.across(mark.x + mark.x_error)));
        marks += fmt::format("<use class=\"mark\" href=\"#{}\" x=\"{}\" y=\"{}\"/>",
                             marker_name(series.look.marker), x, y);
    }
    return (bars.empty() ? "" : fmt::format("<path class=\"bar\" d=\"{}\"/>", bars)) + marks;
}

std::string series_of(const Series& series, const Frame& frame) {
    const std::string path = path_of(series.line, frame);
    return fmt::format("<g class=\"series {}\" data-name=\"{}\">{}{}{}</g>", classes(series.look),
                       escaped(series.name), band_of(series, frame),
                       path.empty() ? "" : fmt::format("<path class=\"line\" d=\"{}\"/>", path),
                       marks_of(series, frame));
}

std::string regions_of(const XyPanel& panel, const Frame& frame, const Box& plot) {
    std::string svg;
    for (const Region& region : panel.regions) {
        const double from = frame.across(region.from);
        const double to = frame.across(region.to);
        if (!(to - from > 0.5)) continue;
        svg += fmt::format("<rect class=\"shade\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                           pixels(from), pixels(plot.top), pixels(to - from), pixels(plot.height));
        if (text_width(region.label, tick_size) < to - from - 6)
            svg += fmt::format("<text class=\"tick soft mid\" x=\"{}\" y=\"{}\">{}</text>",
                               pixels((from + to) / 2), pixels(plot.top + plot.height - 6),
                               escaped(region.label));
    }
    return svg;
}

std::string rules_of(const XyPanel& panel, const Frame& frame, const Box& plot) {
    std::string svg;
    double label_y = plot.top + 12;
    for (const Rule& rule : panel.rules) {
        const double x = frame.across(rule.x);
        svg += fmt::format("<g class=\"{}\">", classes(rule.look));
        if (rule.interval) {
            const double from = frame.across(rule.interval->from);
            svg += fmt::format("<rect class=\"band\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                               pixels(from), pixels(plot.top), pixels(frame.across(rule.interval->to) - from),
                               pixels(plot.height));
        }
        svg += fmt::format("<path class=\"rule\" d=\"M{} {}V{}\"/></g>", pixels(x), pixels(plot.top),
                           pixels(plot.top + plot.height));
        if (rule.label.empty()) continue;
        const double width = text_width(rule.label, tick_size);
        const bool left = x + width + 6 > plot.left + plot.width;
        svg += fmt::format("<text class=\"tick soft{}\" x=\"{}\" y=\"{}\">{}</text>", left ? " end" : "",
                           pixels(left ? x - 4 : x + 4), pixels(label_y), subscripted(rule.label));
        label_y += 14;
    }
    return svg;
}

/// The ends along one coordinate of the points and marks of a panel.
Range extent(const XyPanel& panel, double Point::*of, double Mark::*at, double Mark::*error) {
    Extent extent;
    for (const Series& series : panel.series) {
        for (const auto* points : {&series.line, &series.band})
            for (const Point& point : *points) extent.take(point.*of);
        for (const Mark& mark : series.marks) {
            extent.take(mark.*at - mark.*error);
            extent.take(mark.*at + mark.*error);
        }
    }
    return extent.range;
}

Range x_extent(const XyPanel& panel) {
    Range range = extent(panel, &Point::x, &Mark::x, &Mark::x_error);
    for (const Rule& rule : panel.rules) {
        const Range ends = rule.interval.value_or(Range{rule.x, rule.x});
        range = {std::min(range.from, ends.from), std::max(range.to, ends.to)};
    }
    return range;
}

Range y_extent(const XyPanel& panel) {
    return extent(panel, &Point::y, &Mark::y, &Mark::y_error);
}

constexpr double row_height = 21;
constexpr double bar_height = 15;

Range extent(const RowPanel& panel) {
    Extent extent;
    for (const Row& row : panel.rows)
        for (const RowItem& item : row.items) {
            if (item.kind != RowItem::Kind::mark) extent.take(item.from);
            extent.take(item.to);
        }
    return extent.range;
}

std::string bar(const RowItem& item, double from, double to, double middle) {
    const double left = std::min(from, to);
    const double width = std::abs(to - from);
    std::string svg = fmt::format(
        "<rect class=\"area\" x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\"/><path class=\"bar\" d=\"M{0} "
        "{1}h{2}v{3}h-{2}z\"/>",
        pixels(left), pixels(middle - bar_height / 2), pixels(width), pixels(bar_height));
    if (text_width(item.legend, tick_size) < width - 6)
        svg += fmt::format("<text class=\"tick mid\" x=\"{}\" y=\"{}\">{}</text>", pixels(left + width / 2),
                           pixels(middle + 4), isolated(item.legend));
    return svg;
}

std::string item_of(const RowItem& item, const Scale& scale, double unit, double row_middle) {
    const double middle = row_middle + item.shift;
    const auto at = [&](double value) {
        const Range& ends = scale.at;
        const double pixel = scale(value / unit);
        return std::isfinite(pixel) ? std::clamp(pixel, ends.from, ends.to) : ends.from;
    };
    std::string svg = fmt::format("<g class=\"series {}\" data-name=\"{}\" data-row=\"{}\">",
                                  classes(item.look), escaped(item.name), pixels(middle));
    switch (item.kind) {
        case RowItem::Kind::bar:
            svg += bar(item, at(item.from), at(item.to), middle);
            break;
        case RowItem::Kind::interval:
            svg +=
                fmt::format("<path class=\"bar\" d=\"M{} {}H{}M{} {}v12M{} {}v12\"/>", pixels(at(item.from)),
                            pixels(middle), pixels(at(item.to)), pixels(at(item.from)), pixels(middle - 6),
                            pixels(at(item.to)), pixels(middle - 6));
            break;
        case RowItem::Kind::mark:
            svg += fmt::format("<use class=\"mark\" href=\"#{}\" x=\"{}\" y=\"{}\"/>",
                               marker_name(item.look.marker), pixels(at(item.to)), pixels(middle));
            break;
    }
    return svg + "</g>";
}

}  // namespace

std::string drawn(const XyPanel& panel, const Box& box) {
    const double label = 16;  // the vertical label
    const double height = box.height - title_height - axis_height;
    const double left = label + tick_width(panel.y, y_extent(panel), height);
    const Box plot{box.left + left, box.top + title_height, box.width - left - 10, height};
    const Scale x = scale_of(panel.x, x_extent(panel), {plot.left, plot.left + plot.width});
    const Scale y = scale_of(panel.y, y_extent(panel), {plot.top + plot.height, plot.top});
    const Frame frame{x, y, panel.x.scale, panel.y.scale};
    std::string svg = fmt::format("<g class=\"panel\" data-title=\"{}\"{}{}>", escaped(panel.title),
                                  axis_data('x', panel.x, x), axis_data('y', panel.y, y));
    svg += title_text(panel.title, {box.left, plot.left, plot.left + plot.width + 8, box.top + 13});
    svg += regions_of(panel, frame, plot);
    svg += horizontal_axis(panel.x, x, plot) + vertical_grid(y, plot);
    svg += fmt::format("<text class=\"mid\" transform=\"translate({} {})rotate(-90)\">{}</text>",
                       pixels(box.left + 11), pixels(plot.top + plot.height / 2), axis_label(panel.y));
    svg += rules_of(panel, frame, plot);
    for (const Series& series : panel.series) svg += series_of(series, frame);
    return svg + frame_of(plot);
}

void share_axes(std::vector<Panel>& panels, bool x, bool y) {
    Range across{infinity, -infinity};
    Range up{infinity, -infinity};
    const auto join = [](Range& into, const Range& other) {
        into = {std::min(into.from, other.from), std::max(into.to, other.to)};
    };
    for (const Panel& panel : panels)
        if (const auto* xy = std::get_if<XyPanel>(&panel)) {
            join(across, x_extent(*xy));
            join(up, y_extent(*xy));
        }
    const auto fix = [](Axis& axis, const Range& extent) {
        const Range ends = with_margin(extent, axis, 0.04);
        if (!axis.from) axis.from = ends.from;
        if (!axis.to) axis.to = ends.to;
    };
    for (Panel& panel : panels)
        if (auto* xy = std::get_if<XyPanel>(&panel)) {
            if (x) fix(xy->x, across);
            if (y) fix(xy->y, up);
        }
}

double height_of(const RowPanel& panel) {
    return title_height + static_cast<double>(panel.rows.size()) * row_height + 8 + axis_height;
}

std::string drawn(const RowPanel& panel, const Box& box) {
    double labels = 0;
    for (const Row& row : panel.rows) labels = std::max(labels, text_width(row.label, tick_size) + 8);
    labels = std::min(labels, 0.58 * box.width);
    const Box plot{box.left + labels, box.top + title_height, box.width - labels - 12,
                   static_cast<double>(panel.rows.size()) * row_height + 8};
    const Scale x = scale_of(panel.x, extent(panel), {plot.left, plot.left + plot.width});
    std::string svg = fmt::format("<g class=\"panel\" data-title=\"{}\"{}>", escaped(panel.title),
                                  axis_data('x', panel.x, x));
    svg += title_text(panel.title, {box.left, box.left, box.left + box.width, box.top + 13});
    svg += horizontal_axis(panel.x, x, plot);
    double middle = plot.top + 4 + row_height / 2;
    for (const Row& row : panel.rows) {
        const std::string label = fitted(row.label, tick_size, labels - 6);
        svg += fmt::format("<text class=\"tick {}\" x=\"{}\" y=\"{}\">{}{}</text>",
                           row.heading ? "title" : "end soft", pixels(row.heading ? box.left : plot.left - 6),
                           pixels(middle + 4), isolated(label),
                           label == row.label ? "" : "<title>" + escaped(row.label) + "</title>");
        for (const RowItem& item : row.items) svg += item_of(item, x, panel.x.scale, middle);
        middle += row_height;
    }
    return svg + frame_of(plot);
}

}  // namespace ashimpact::report
