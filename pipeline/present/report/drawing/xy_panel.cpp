// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/present/report/drawing/axes.hpp"
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

    [[nodiscard]] double across(double value) const { return held(x(value / x_unit), x.at()); }
    [[nodiscard]] double up(double value) const { return held(y(value / y_unit), y.at()); }
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
        const Range& range = scale.values();
        const double slack = 1e-9 * (range.to - range.from);
        return value >= range.from - slack && value <= range.to + slack;
    }
};

struct Pixel {
    double x;
    double y;
};

/// Whether all pixels between two lie within a twentieth of a pixel of the line that joins them.
bool is_straight(const std::vector<Pixel>& all, std::size_t first, std::size_t last) {
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
std::string polyline(const std::vector<Pixel>& all) {
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
    std::vector<Pixel> piece;
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
    std::vector<Pixel> outline;
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
    for (const Rule& rule : panel.rules) {
        const double x = frame.across(rule.x);
        svg += fmt::format("<g class=\"{}\"><path class=\"rule\" d=\"M{} {}V{}\"/></g>", classes(rule.look),
                           pixels(x), pixels(plot.top), pixels(plot.top + plot.height));
        if (rule.label.empty()) continue;
        const double width = text_width(rule.label, tick_size);
        const bool left = x + width + 6 > plot.left + plot.width;
        svg += fmt::format("<text class=\"tick soft{}\" x=\"{}\" y=\"{}\">{}</text>", left ? " end" : "",
                           pixels(left ? x - 4 : x + 4), pixels(plot.top + 12), subscripted(rule.label));
    }
    return svg;
}

template <class Coordinate, class Error>
Range extent(const XyPanel& panel, Coordinate&& of, Error&& error) {
    Range range{infinity, -infinity};
    const auto take = [&](double value) {
        if (!std::isfinite(value)) return;
        range.from = std::min(range.from, value);
        range.to = std::max(range.to, value);
    };
    for (const Series& series : panel.series) {
        for (const Point& point : series.line) take(of(point));
        for (const Point& point : series.band) take(of(point));
        for (const Mark& mark : series.marks) {
            const double value = of(Point{mark.x, mark.y});
            take(value - error(mark));
            take(value + error(mark));
        }
    }
    return range;
}

}  // namespace

Range x_extent(const XyPanel& panel) {
    Range range = extent(
        panel, [](const Point& p) { return p.x; }, [](const Mark& m) { return m.x_error; });
    for (const Rule& rule : panel.rules) {
        range.from = std::min(range.from, rule.x);
        range.to = std::max(range.to, rule.x);
    }
    return range;
}

Range y_extent(const XyPanel& panel) {
    return extent(
        panel, [](const Point& p) { return p.y; }, [](const Mark& m) { return m.y_error; });
}

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
    svg += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></g>",
                       pixels(plot.left), pixels(plot.top), pixels(plot.width), pixels(plot.height));
    return svg;
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
    for (Panel& panel : panels)
        if (auto* xy = std::get_if<XyPanel>(&panel)) {
            const auto fix = [](Axis& axis, Range range) {
                range = drawable(range, axis.spacing);
                const bool logarithmic = axis.spacing == Spacing::logarithmic;
                const double margin =
                    logarithmic ? std::pow(range.to / range.from, 0.04) : 0.04 * (range.to - range.from);
                if (!axis.from)
                    axis.from = logarithmic                         ? range.from / margin
                                : axis.from_zero && range.from >= 0 ? 0.0
                                                                    : range.from - margin;
                if (!axis.to) axis.to = logarithmic ? range.to * margin : range.to + margin;
            };
            if (x) fix(xy->x, across);
            if (y) fix(xy->y, up);
        }
}

}  // namespace ashimpact::report
