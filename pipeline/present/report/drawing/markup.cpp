// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/markup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <nettle/base64.h>

#include "core/text/text.hpp"

namespace ashimpact::report {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

struct Entity {
    std::string_view character, entity;
};
constexpr std::array entities{Entity{"&", "&amp;"}, Entity{"<", "&lt;"}, Entity{">", "&gt;"},
                              Entity{"\"", "&quot;"}, Entity{"'", "&#39;"}};

/// Width of a character over the font size.
double relative_width(char32_t value) {
    if (value < 0x80) {
        const auto character = static_cast<char>(value);
        if (std::string_view("iljtfI.,:;|'!()[]/ ").find(character) != std::string_view::npos) return 0.36;
        if (std::string_view("mwMW%@").find(character) != std::string_view::npos) return 0.95;
        if (std::string_view("<>=+~^#&").find(character) != std::string_view::npos) return 0.84;
        return value >= 'A' && value <= 'Z' ? 0.72 : 0.61;
    }
    return value < 0x1100 ? 0.7 : 1.1;
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

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

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for_each_character(text, [&](const Character& character) {
        const std::string_view bytes = character.bytes;
        const bool no_character = (character.code_point & 0xfffeU) == 0xfffeU;  // which XML forbids
        if (!character.valid || no_character)
            out += replacement;
        else if (const auto* markup = std::ranges::find(entities, bytes, &Entity::character);
                 markup != entities.end())
            out += markup->entity;
        else if (!character.is_control())
            out += bytes;
    });
    return out;
}

std::string subscripted(std::string_view label) {
    std::string out;
    for (std::size_t i = 0; i < label.size();) {
        if (label[i] != '_' || i == 0 || i + 1 == label.size() || !is_word(label[i + 1])) {
            const std::string_view bytes = first_character(label.substr(i)).bytes;
            out += escaped(bytes);
            i += bytes.size();
            continue;
        }
        std::size_t end = i + 1;
        while (end < label.size() && is_word(label[end])) ++end;
        out += fmt::format("<tspan class=\"sub\" dy=\"3\">{}</tspan><tspan dy=\"-3\">&#8203;</tspan>",
                           label.substr(i + 1, end - i - 1));
        i = end;
    }
    return out;
}

std::string pixels(double value) {
    if (!std::isfinite(value)) return "0";
    const long long hundredths = std::llround(value * 100);
    const long long magnitude = std::abs(hundredths);
    std::string text = (hundredths < 0 ? "-" : "") + std::to_string(magnitude / 100);
    const auto digit = [](long long number) { return static_cast<char>('0' + number % 10); };
    if (magnitude % 100 == 0) return text;
    text += '.';
    text += digit(magnitude / 10);
    if (magnitude % 10 != 0) text += digit(magnitude);
    return text;
}

double text_width(std::string_view text, double font_size) {
    double width = 0;
    for_each_character(text,
                       [&](const Character& character) { width += relative_width(character.code_point); });
    return width * font_size;
}

std::string fitted(std::string_view text, double font_size, double most) {
    if (text_width(text, font_size) <= most) return std::string(text);
    std::string out;
    double width = font_size;  // of the ellipsis
    bool full = false;
    for_each_character(text, [&](const Character& character) {
        width += relative_width(character.code_point) * font_size;
        full = full || width > most;
        if (!full) out += character.bytes;
    });
    return out + "…";
}

std::string isolated(std::string_view name) {
    return is_ascii(name) ? escaped(name) : "\u2068" + escaped(name) + "\u2069";
}

std::string base64(std::string_view bytes) {
    std::string out(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    base64_encode_raw(out.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    return out;
}

std::string percent_encoded(std::string_view text) {
    constexpr std::string_view hexadecimal = "0123456789ABCDEF";
    std::string out;
    out.reserve(text.size() + text.size() / 4);
    for (const char c : text) {
        if (is_word(c) || std::string_view("-_.,:/ ").find(c) != std::string_view::npos)
            out += c == ' ' ? std::string("%20") : std::string(1, c);
        else
            out += {'%', hexadecimal[static_cast<unsigned char>(c) / 16],
                    hexadecimal[static_cast<unsigned char>(c) % 16]};
    }
    return out;
}

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
