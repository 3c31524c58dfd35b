// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/figure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/wait.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

namespace {

constexpr double wide_pixels = 840;
constexpr double narrow_pixels = 340;
constexpr double legend_row = 20;

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
            "x=\"{0}\" y=\"{1}\" width=\"22\" height=\"10\"/>",
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

/// A cell of a CSV file. A name such as "=1+1" gets an apostrophe in front, or spreadsheets would compute it.
std::string csv_cell(const Cell& cell) {
    std::string text = cell_text(cell);
    if (std::holds_alternative<std::string>(cell) && text.find_first_of("=+-@\t\r") == 0) text.insert(0, "'");
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

constexpr const char* converter = "rsvg-convert";

/// What the converter makes of an SVG, which it reads from a nameless file, so that no pipe can block.
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

constexpr double rounding = 1e-9;  // relative: a tick on the end of its axis counts

std::vector<double> linear_ticks(Range range, int most) {
    const double width = range.to - range.from;
    const double power = std::pow(10.0, std::floor(std::log10(width / most)));
    double step = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        step = factor * power;
        if (std::floor(range.to / step + rounding) - std::ceil(range.from / step - rounding) + 1 <= most)
            break;
    }
    const double first = std::ceil(range.from / step - rounding);
    const auto count = static_cast<int>(std::floor(range.to / step + rounding) - first) + 1;
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(std::max(count, 0)));
    for (int i = 0; i < count; ++i) values.push_back((first + i) * step);
    return values;
}

std::vector<double> decade_ticks(Range range, std::span<const double> digits) {
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(range.from))) - 1;
    const auto last = static_cast<int>(std::ceil(std::log10(range.to)));
    for (int decade = first; decade <= last; ++decade)
        for (const double digit : digits) {
            const double value = digit * std::pow(10.0, decade);
            if (value >= range.from * (1 - rounding) && value <= range.to * (1 + rounding))
                values.push_back(value);
        }
    return values;
}

std::vector<double> logarithmic_ticks(Range range, int most) {
    constexpr std::array all{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
    constexpr std::array some{1.0, 2.0, 5.0};
    constexpr std::array one{1.0};
    // Within a decade even steps, where there is room for finer ones than its digits.
    if (const auto count = decade_ticks(range, all).size();
        range.to < 10 * range.from && static_cast<int>(count) <= most)
        if (auto even = linear_ticks(range, most); even.size() > count) return even;
    for (const std::span<const double> digits :
         {std::span<const double>(all), std::span<const double>(some), std::span<const double>(one)}) {
        auto values = decade_ticks(range, digits);
        if (static_cast<int>(values.size()) <= most && values.size() >= 2) return values;
    }
    auto decades = decade_ticks(range, one);
    if (static_cast<int>(decades.size()) <= most) return linear_ticks(range, most);
    std::vector<double> thinned;
    const std::size_t every = decades.size() / static_cast<std::size_t>(most) + 1;
    for (std::size_t i = 0; i < decades.size(); i += every) thinned.push_back(decades[i]);
    return thinned;
}

/// The ends of an axis in its shown unit, with a margin that keeps marks off the frame.
Range shown_range(const Axis& axis, const Range& extent) {
    Range ends = with_margin(extent, axis, 0.05);
    if (axis.from) ends.from = *axis.from;
    if (axis.to) ends.to = *axis.to;
    ends = drawable(ends, axis.spacing);
    return {ends.from / axis.scale, ends.to / axis.scale};
}

int vertical_ticks(double height) {
    return std::max(3, static_cast<int>(height / 28));
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
        "role=\"img\"><title>{4}</title>{8}<style>{5}</style><defs>{6}</defs><rect class=\"paper\" "
        "width=\"{0}\" height=\"{1}\"/>{7}</svg>\n",
        pixels(width), pixels(top), pixels(millimetres), pixels(millimetres * top / width), label, style,
        marker_definitions(), body, own_figure_mark);
}

bool is_own_svg(std::string_view svg) {
    return svg.find(own_figure_mark) != std::string_view::npos;
}

std::string csv_of(const NumberTable& table) {
    std::string text;
    const auto add = [&](const auto& row) {
        for (const auto& cell : row) text += csv_cell(cell) + ",";
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

double Scale::operator()(double value) const {
    const double share = spacing == Spacing::linear
                             ? (value - values.from) / (values.to - values.from)
                             : std::log(value / values.from) / std::log(values.to / values.from);
    return at.from + share * (at.to - at.from);
}

std::vector<Tick> Scale::ticks(int most) const {
    std::vector<Tick> ticks;
    const bool linear = spacing == Spacing::linear;
    const double least = 1e-9 * std::max(std::abs(values.from), std::abs(values.to));
    for (const double value : linear ? linear_ticks(values, most) : logarithmic_ticks(values, most)) {
        const double shown = linear && std::abs(value) < least ? 0 : value;
        ticks.push_back({shown, number_label(shown)});
    }
    return ticks;
}

Range drawable(Range range, Spacing spacing) {
    if (!std::isfinite(range.from) || !std::isfinite(range.to) || range.from > range.to) range = {1, 2};
    if (spacing == Spacing::logarithmic) {
        if (!(range.to > 0)) return {0.1, 1};
        if (!(range.from > 0)) range.from = range.to * 1e-3;
        if (range.to < 1.05 * range.from) return {range.from / 1.5, range.to * 1.5};
        return range;
    }
    if (range.to - range.from > 1e-9 * std::max(std::abs(range.from), std::abs(range.to))) return range;
    const double half = range.to == 0 ? 1 : 0.1 * std::abs(range.to);
    return {range.from - half, range.to + half};
}

Range with_margin(Range extent, const Axis& axis, double share) {
    extent = drawable(extent, axis.spacing);
    if (axis.spacing == Spacing::logarithmic) {
        const double margin = std::pow(extent.to / extent.from, share);
        return {extent.from / margin, extent.to * margin};
    }
    const double margin = share * (extent.to - extent.from);
    return {axis.from_zero && extent.from >= 0 ? 0 : extent.from - margin, extent.to + margin};
}

std::string number_label(double value) {
    std::string text = fmt::format("{:.6g}", value);
    const auto e = text.find('e');
    if (e == std::string::npos) return text;
    constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const int exponent = std::stoi(text.substr(e + 1));
    std::string power = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        power += raised[static_cast<std::size_t>(digit - '0')];
    const std::string mantissa = text.substr(0, e);
    return (mantissa == "1" ? "10" : mantissa + "·10") + power;
}

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
    std::vector<Tick> ticks = scale.ticks(std::max(4, static_cast<int>(plot.width / 40)));
    // Of labels that would touch, that of a whole decade stays, else the left one.
    if (scale.spacing == Spacing::logarithmic)
        std::stable_partition(ticks.begin(), ticks.end(), [](const Tick& tick) {
            const double decade = std::log10(tick.value);
            return std::abs(decade - std::round(decade)) < rounding;
        });
    std::vector<Range> taken;
    for (const Tick& tick : ticks) {
        const double x = scale(tick.value);
        grid += fmt::format("M{} {}V{}", pixels(x), pixels(plot.top), pixels(bottom));
        const double half = text_width(tick.label, tick_size) / 2;
        if (std::ranges::any_of(taken, [&](const Range& label) {
                return x - half < label.to + 4 && x + half > label.from - 4;
            }))
            continue;
        taken.push_back({x - half, x + half});
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
                       shortest(scale.values.from), shortest(scale.values.to), pixels(scale.at.from),
                       pixels(scale.at.to), scale.spacing == Spacing::logarithmic ? "log" : "linear",
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
