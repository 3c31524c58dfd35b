// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/figure.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <sys/wait.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
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

/// The legend, and its height.
std::pair<std::string, double> drawn_legend(const Figure& figure, double width) {
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

constexpr const char* converter = "rsvg-convert";

/// What the converter makes of an SVG. A pipe leads out of it alone, a file without a name into it, so that
/// neither waits for the other.
std::string converted(const std::string& svg, std::string_view options) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::tmpfile(), std::fclose);
    if (!in || std::fwrite(svg.data(), 1, svg.size(), in.get()) != svg.size() || std::fflush(in.get()) != 0)
        throw std::system_error(errno, std::generic_category(), "temporary file");
    // The variable is the date that PDF files carry.
    const std::string command =
        fmt::format("command -v {0} >/dev/null || exit 127; SOURCE_DATE_EPOCH=0 exec {0} {1} </dev/fd/{2}",
                    converter, options, fileno(in.get()));
    std::FILE* const out = popen(command.c_str(), "r");
    if (out == nullptr)
        throw InputError("cannot be started: " + std::generic_category().message(errno)).at(converter);
    std::string output;
    std::vector<char> block(65536);
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), out))
        output.append(block.data(), count);
    const int status = pclose(out);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw InputError(std::string(converter) + " is missing, which makes PDF and PNG of an SVG",
                         "the Debian package librsvg2-bin, or a file that ends in .svg")
            .at(converter);
    if (status != 0 || output.empty())
        throw InputError("failed to convert the figure",
                         "a working librsvg2-bin, or a file that ends in .svg")
            .at(converter);
    return output;
}

}  // namespace

std::string svg_of(const Figure& figure, Width form, const std::string& style) {
    const double width = form == Width::wide ? wide_pixels : narrow_pixels;
    const int columns = std::max(1, std::min(form == Width::wide ? figure.columns : figure.narrow_columns,
                                             static_cast<int>(figure.panels.size())));
    const double gap = 14;
    const double panel_width = (width - gap * (columns - 1)) / columns;
    auto [body, top] = drawn_legend(figure, width);
    top += 4;
    for (std::size_t first = 0; first < figure.panels.size(); first += static_cast<std::size_t>(columns)) {
        const std::size_t end = std::min(figure.panels.size(), first + static_cast<std::size_t>(columns));
        double row = 0;
        for (std::size_t i = first; i < end; ++i) {
            const auto* rows = std::get_if<RowPanel>(&figure.panels[i]);
            row = std::max(row, rows != nullptr ? height_of(*rows) : figure.panel_height);
        }
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

bool is_own_svg(std::string_view svg) {
    return svg.find(own_mark) != std::string_view::npos;
}

std::string csv_of(const NumberTable& table) {
    std::string text;
    const auto add = [&](const auto& row) {
        for (const auto& cell : row) text += csv_cell(cell_text(cell)) + ",";
        text.back() = '\n';
    };
    add(table.columns);
    for (const auto& row : table.rows) add(row);
    return text;
}

FigureFormat format_of(const std::filesystem::path& file) {
    const std::string ending = lower_case(file.extension().string());
    if (ending == ".svg") return FigureFormat::svg;
    if (ending == ".pdf") return FigureFormat::pdf;
    if (ending == ".png") return FigureFormat::png;
    throw InputError("the file name " + in_quotes(file.filename().string()) + " tells no format",
                     "one that ends in .svg, .pdf or .png")
        .at("-o");
}

void require_converter(FigureFormat format) {
    if (format != FigureFormat::svg) static_cast<void>(converted("", "--version"));
}

std::string figure_bytes(const Figure& figure, Width width, FigureFormat format) {
    std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg_of(figure, width, drawing_style());
    if (format == FigureFormat::svg) return svg;
    if (format == FigureFormat::pdf) return converted(svg, "--format=pdf");
    return converted(svg, "--format=png --dpi-x=600 --dpi-y=600");
}

}  // namespace ashimpact::report
