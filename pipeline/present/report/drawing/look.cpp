// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/look.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

namespace ashimpact::report {

namespace {

struct Colour {
    std::string_view light;
    std::string_view dark;
};

/// They differ for people who see no red or no green; each has a contrast of at least 3:1 on its page.
constexpr std::array colours{
    Colour{"#1259a7", "#79b8ff"}, Colour{"#c24a00", "#ff9d5c"}, Colour{"#00775c", "#3fd8b0"},
    Colour{"#a23685", "#f09ad8"}, Colour{"#7d6100", "#e2c044"}, Colour{"#c2185b", "#ff8fab"},
    Colour{"#5b4bb5", "#b3a8ff"}, Colour{"#4a6b1d", "#b5d96a"},
};

constexpr std::array<std::string_view, 7> dashes{"none", "8 3",          "2.5 2.5", "9 3 2 3",
                                                 "5 2",  "12 3 2 3 2 3", "1.5 4"};

constexpr std::array<std::string_view, 7> markers{
    "<circle r=\"3.5\"/>",
    "<path d=\"M-3.2-3.2h6.4v6.4h-6.4z\"/>",
    "<path d=\"M0-4.2 4 3H-4z\"/>",
    "<path d=\"M0-4.6 4.2 0 0 4.6-4.2 0z\"/>",
    "<path d=\"M0 4.2 4-3H-4z\"/>",
    "<path d=\"M-3.2-3.2 3.2 3.2M3.2-3.2-3.2 3.2\"/>",
    "<path d=\"M-4.2 0h8.4M0-4.2v8.4\"/>",
};

struct Theme {
    std::string_view ink;
    std::string_view soft;
    std::string_view grid;
    std::string_view paper;
    std::string_view shade;
    bool dark;
};

constexpr Theme light{"#1b1f24", "#57606a", "#dfe3e8", "#ffffff", "#eceff3", false};
constexpr Theme dark{"#e6edf3", "#a3adb8", "#30363d", "#0f1419", "#1c232b", true};

std::string theme_style(const Theme& theme) {
    std::string css = fmt::format(
        "svg text{{fill:{0}}}svg .soft{{fill:{1}}}.frame{{stroke:{1}}}.grid{{stroke:{2}}}.paper{{fill:{3}}}"
        ".shade{{fill:{4}}}.ink{{color:{0}}}.solid{{fill:currentColor}}.hollow{{fill:{3}}}",
        theme.ink, theme.soft, theme.grid, theme.paper, theme.shade);
    for (std::size_t i = 0; i < colours.size(); ++i)
        css += fmt::format(".k{}{{color:{}}}", i, theme.dark ? colours[i].dark : colours[i].light);
    return css;
}

std::string shape_style() {
    std::string css =
        "svg text{font-family:system-ui,'Helvetica Neue',Arial,'DejaVu Sans',sans-serif;font-size:12px}"
        "svg .tick{font-size:11px}svg .title{font-weight:600}svg .sub{font-size:9px}svg .end{text-anchor:end}"
        "svg .mid{text-anchor:middle}.grid,.frame{fill:none;stroke-width:1}"
        ".line{fill:none;stroke:currentColor;stroke-width:1.8;stroke-linejoin:round}.thin "
        ".line{stroke-width:1.1}"
        ".mark{stroke:currentColor;stroke-width:1.4}.bar{stroke:currentColor;stroke-width:1.2;fill:none}"
        ".band{fill:currentColor;fill-opacity:.16;stroke:none}.area{fill:currentColor;fill-opacity:.42;"
        "stroke:none}"
        ".rule{stroke:currentColor;stroke-width:1.2;stroke-dasharray:3 3;fill:none}";
    for (std::size_t i = 0; i < dashes.size(); ++i)
        css += fmt::format(".d{} .line{{stroke-dasharray:{}}}", i, dashes[i]);
    return css;
}

}  // namespace

Look Look::of(std::size_t index, bool hollow) {
    return {.colour = index % colours.size(),
            .dash = index % dashes.size(),
            .marker = index % markers.size(),
            .hollow = hollow};
}

Look Look::plain(std::size_t marker, bool hollow) {
    return {.marker = marker % markers.size(), .hollow = hollow, .neutral = true};
}

std::string classes(const Look& look) {
    return fmt::format("{} d{} {}{}", look.neutral ? "ink" : fmt::format("k{}", look.colour), look.dash,
                       look.hollow ? "hollow" : "solid", look.thin ? " thin" : "");
}

std::string drawing_style() {
    return shape_style() + theme_style(light);
}

std::string page_drawing_style() {
    return shape_style() + theme_style(light) + "@media screen and (prefers-color-scheme:dark){" +
           theme_style(dark) + "}";
}

std::string marker_definitions() {
    std::string text;
    for (std::size_t i = 0; i < markers.size(); ++i)
        text += fmt::format("<g id=\"{}\">{}</g>", marker_name(i), markers[i]);
    return text;
}

std::string marker_name(std::size_t marker) {
    return fmt::format("m{}", marker % markers.size());
}

}  // namespace ashimpact::report
