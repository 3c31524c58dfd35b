// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/present/report/drawing/axes.hpp"
#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

namespace {

constexpr double wide_pixels = 840;
constexpr double narrow_pixels = 340;
constexpr double legend_row = 20;
constexpr std::string_view own_mark = "<metadata>ashimpact</metadata>";

struct LegendEntry {
    std::string text;
    Look look;
    bool line = false;
    bool mark = false;
    bool area = false;
};

void take(std::vector<LegendEntry>& entries, const LegendEntry& entry) {
    if (entry.text.empty()) return;
    for (LegendEntry& known : entries)
        if (known.text == entry.text) {
            known.line = known.line || entry.line;
            if (entry.mark && !known.mark) known.look.hollow = entry.look.hollow;
            known.mark = known.mark || entry.mark;
            return;
        }
    entries.push_back(entry);
}

std::vector<LegendEntry> legend_of(const Figure& figure) {
    std::vector<LegendEntry> entries;
    for (const Panel& panel : figure.panels) {
        if (const auto* xy = std::get_if<XyPanel>(&panel))
            for (const Series& series : xy->series)
                take(entries,
                     {series.legend, series.look, !series.line.empty(), !series.marks.empty(), series.area});
        if (const auto* rows = std::get_if<RowPanel>(&panel))
            for (const Row& row : rows->rows)
                for (const RowItem& item : row.items)
                    take(entries, {item.legend, item.look, item.kind == RowItem::Kind::interval,
                                   item.kind == RowItem::Kind::mark, item.kind == RowItem::Kind::bar});
    }
    return entries;
}

struct Legend {
    std::string svg;
    double height;
};

std::string swatch(const LegendEntry& entry, double x, double y) {
    std::string svg = fmt::format("<g class=\"{}\">", classes(entry.look));
    if (entry.area)
        svg += fmt::format(
            "<rect class=\"area\" x=\"{0}\" y=\"{1}\" width=\"22\" height=\"10\"/><rect class=\"bar\" "
            "x=\"{0}\" y=\"{1}\" "
            "width=\"22\" height=\"10\"/>",
            pixels(x), pixels(y - 5));
    if (entry.line && !entry.area)
        svg += fmt::format("<path class=\"line\" d=\"M{} {}h26\"/>", pixels(x), pixels(y));
    if (entry.mark)
        svg += fmt::format("<use class=\"mark\" href=\"#{}\" x=\"{}\" y=\"{}\"/>",
                           marker_name(entry.look.marker), pixels(x + 13), pixels(y));
    return svg + "</g>";
}

Legend drawn_legend(const Figure& figure, double width) {
    const auto entries = legend_of(figure);
    if (entries.empty()) return {"", 0};
    double x = 4;
    double y = 10;
    std::string svg;
    for (const LegendEntry& entry : entries) {
        const std::string text = fitted(entry.text, label_size, width - 50);
        const double needed = 32 + text_width(text, label_size) + 14;
        if (x > 4 && x + needed - 14 > width) {
            x = 4;
            y += legend_row;
        }
        svg += swatch(entry, x, y) + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", pixels(x + 32),
                                                 pixels(y + 4), isolated(text));
        x += needed;
    }
    return {"<g class=\"legend\">" + svg + "</g>", y + legend_row - 4};
}

double height_of(const Panel& panel, double of_xy) {
    if (const auto* rows = std::get_if<RowPanel>(&panel)) return height_of(*rows);
    return of_xy;
}

std::string cell_text(const Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell))
        return std::isfinite(*number) ? fmt::format("{:.7g}", *number) : "";
    return std::get<std::string>(cell);
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

std::string svg_of(const Figure& figure, Width form, const std::string& style) {
    const double width = form == Width::wide ? wide_pixels : narrow_pixels;
    const int columns = std::max(1, std::min(form == Width::wide ? figure.columns : figure.narrow_columns,
                                             static_cast<int>(figure.panels.size())));
    const double gap = 14;
    const double panel_width = (width - gap * (columns - 1)) / columns;
    const Legend legend = drawn_legend(figure, width);
    std::string body = legend.svg;
    double top = legend.height + 4;
    for (std::size_t first = 0; first < figure.panels.size(); first += static_cast<std::size_t>(columns)) {
        const std::size_t end = std::min(figure.panels.size(), first + static_cast<std::size_t>(columns));
        double row = 0;
        for (std::size_t i = first; i < end; ++i)
            row = std::max(row, height_of(figure.panels[i], figure.panel_height));
        for (std::size_t i = first; i < end; ++i) {
            const Box box{static_cast<double>(i - first) * (panel_width + gap), top, panel_width, row};
            body += std::visit([&](const auto& panel) { return drawn(panel, box); }, figure.panels[i]);
        }
        top += row + 8;
    }
    const std::string label = escaped(figure.title);
    if (style.empty())
        return fmt::format("<svg class=\"{}\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>",
                           form == Width::wide ? "wide" : "narrow", pixels(width), pixels(top), label, body);
    const double millimetres = form == Width::wide ? 170 : 85;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{2}mm\" height=\"{3}mm\" "
        "role=\"img\">"
        "<title>{4}</title>{8}<style>{5}</style><defs>{6}</defs><rect class=\"paper\" width=\"{0}\" "
        "height=\"{1}\"/>{7}</svg>\n",
        pixels(width), pixels(top), pixels(millimetres), pixels(millimetres * top / width), label, style,
        marker_definitions(), body, own_mark);
}

std::string svg_file(const Figure& figure, Width width) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg_of(figure, width, drawing_style());
}

bool is_own_svg(std::string_view svg) {
    return svg.find(own_mark) != std::string_view::npos;
}

std::string csv_of(const NumberTable& table) {
    std::string text;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        text += (i > 0 ? "," : "") + csv_cell(table.columns[i]);
    text += "\n";
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + csv_cell(cell_text(row[i]));
        text += "\n";
    }
    return text;
}

}  // namespace ashimpact::report
