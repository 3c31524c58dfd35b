// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/text/text.hpp"
#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

namespace {

/// The ends of an axis in its shown unit, with a margin that keeps marks off the frame.
Range shown_range(const Axis& axis, Range extent) {
    extent = drawable(extent, axis.spacing);
    if (axis.spacing == Spacing::logarithmic) {
        const double margin = std::pow(extent.to / extent.from, 0.05);
        extent = {extent.from / margin, extent.to * margin};
    } else {
        const double margin = 0.05 * (extent.to - extent.from);
        const bool grounded = axis.from_zero && extent.from >= 0;
        extent = {grounded ? 0 : extent.from - margin, extent.to + margin};
    }
    if (axis.from) extent.from = *axis.from;
    if (axis.to) extent.to = *axis.to;
    extent = drawable(extent, axis.spacing);
    return {extent.from / axis.scale, extent.to / axis.scale};
}

int vertical_ticks(double height) {
    return std::max(3, static_cast<int>(height / 28));
}

}  // namespace

std::string axis_label(const Axis& axis) {
    return subscripted(axis.label) + (axis.unit.empty() ? "" : " [" + escaped(axis.unit) + "]");
}

Scale scale_of(const Axis& axis, Range extent, Range at) {
    return {axis.spacing, shown_range(axis, extent), at};
}

std::string horizontal_axis(const Axis& axis, const Scale& scale, const Box& plot) {
    std::string svg;
    std::string grid;
    const double bottom = plot.top + plot.height;
    double free_from = -1e9;
    for (const Tick& tick : scale.ticks(std::max(4, static_cast<int>(plot.width / 40)))) {
        const double x = scale(tick.value);
        grid += fmt::format("M{} {}V{}", pixels(x), pixels(plot.top), pixels(bottom));
        const double half = text_width(tick.label, tick_size) / 2;
        if (x - half < free_from) continue;  // would touch the label before it
        free_from = x + half + 4;
        svg += fmt::format("<text class=\"tick mid soft\" x=\"{}\" y=\"{}\">{}</text>",
                           pixels(std::min(x, plot.left + plot.width + 8 - half)), pixels(bottom + 14),
                           tick.label);
    }
    svg = fmt::format("<path class=\"grid\" d=\"{}\"/>", grid) + svg;
    // A label that is wider than its axis ends with the drawing and begins further left.
    const double half = text_width(axis.label + " [" + axis.unit + "]", label_size) / 2;
    const double middle = std::min(plot.left + plot.width / 2, plot.left + plot.width + 8 - half);
    return svg + fmt::format("<text class=\"mid\" x=\"{}\" y=\"{}\">{}</text>", pixels(middle),
                             pixels(bottom + 30), axis_label(axis));
}

std::string vertical_grid(const Scale& scale, const Box& plot) {
    std::string svg;
    std::string grid;
    for (const Tick& tick : scale.ticks(vertical_ticks(plot.height))) {
        const double y = scale(tick.value);
        grid += fmt::format("M{} {}H{}", pixels(plot.left), pixels(y), pixels(plot.left + plot.width));
        svg += fmt::format("<text class=\"tick end soft\" x=\"{}\" y=\"{}\">{}</text>", pixels(plot.left - 5),
                           pixels(y + 4), tick.label);
    }
    return fmt::format("<path class=\"grid\" d=\"{}\"/>", grid) + svg;
}

double tick_width(const Axis& axis, Range extent, double height) {
    double width = 0;
    for (const Tick& tick : scale_of(axis, extent, {height, 0}).ticks(vertical_ticks(height)))
        width = std::max(width, text_width(tick.label, tick_size));
    return width + 8;
}

std::string axis_data(char which, const Axis& axis, const Scale& scale) {
    return fmt::format(" data-{0}=\"{1} {2} {3} {4} {5}\" data-{0}-name=\"{6}\" data-{0}-unit=\"{7}\"", which,
                       shortest(scale.values().from), shortest(scale.values().to), pixels(scale.at().from),
                       pixels(scale.at().to), scale.spacing() == Spacing::logarithmic ? "log" : "linear",
                       escaped(axis.label), escaped(axis.unit));
}

std::string title_text(const std::string& title, const TitlePlace& place) {
    if (title.empty()) return {};
    const double room = place.end - place.least;
    // A long title is set smaller before it is cut: as a class of the style sheet and its share of the size.
    static constexpr std::array<std::pair<std::string_view, double>, 3> sizes{
        {{"title", 1.0}, {"title tick", tick_size / label_size}, {"title sub", subscript_size / label_size}}};
    const auto* const size = std::find_if(sizes.begin(), sizes.end() - 1, [&](const auto& each) {
        return text_width(title, title_size * each.second) <= room;
    });
    const double font_size = title_size * size->second;
    const std::string shown = fitted(title, font_size, room);
    const double x = std::clamp(place.end - text_width(shown, font_size), place.least, place.x);
    const std::string whole = shown == title ? "" : "<title>" + escaped(title) + "</title>";
    return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}{}</text>", size->first, pixels(x),
                       pixels(place.y), isolated(shown), whole);
}

}  // namespace ashimpact::report
