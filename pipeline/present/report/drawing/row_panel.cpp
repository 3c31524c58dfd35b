// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/present/report/drawing/axes.hpp"
#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

namespace {

constexpr double row_height = 21;
constexpr double bar_height = 15;

Range extent(const RowPanel& panel) {
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Row& row : panel.rows)
        for (const RowItem& item : row.items) {
            const bool mark = item.kind == RowItem::Kind::mark;
            for (const double value : {mark ? item.to : item.from, item.to}) {
                if (!std::isfinite(value)) continue;
                range.from = std::min(range.from, value);
                range.to = std::max(range.to, value);
            }
        }
    return range;
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
        const Range& ends = scale.at();
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
            svg += fmt::format("<path class=\"bar\" d=\"M{} {}H{}M{} {}v8M{} {}v8\"/>", pixels(at(item.from)),
                               pixels(middle), pixels(at(item.to)), pixels(at(item.from)), pixels(middle - 4),
                               pixels(at(item.to)), pixels(middle - 4));
            break;
        case RowItem::Kind::mark:
            svg += fmt::format("<use class=\"mark\" href=\"#{}\" x=\"{}\" y=\"{}\"/>",
                               marker_name(item.look.marker), pixels(at(item.to)), pixels(middle));
            break;
    }
    return svg + "</g>";
}

}  // namespace

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
    return svg + fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></g>",
                             pixels(plot.left), pixels(plot.top), pixels(plot.width), pixels(plot.height));
}

}  // namespace ashimpact::report
