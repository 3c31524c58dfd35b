// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/markup.hpp"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "core/text/utf8.hpp"

namespace ashimpact::report {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

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

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for_each_character(text, [&](const Character& character) {
        const std::string_view bytes = character.bytes;
        const bool no_character = (character.code_point & 0xfffeU) == 0xfffeU;  // which XML forbids
        if (!character.valid || no_character)
            out += replacement;
        else if (bytes == "&")
            out += "&amp;";
        else if (bytes == "<")
            out += "&lt;";
        else if (bytes == ">")
            out += "&gt;";
        else if (bytes == "\"")
            out += "&quot;";
        else if (bytes == "'")
            out += "&#39;";
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
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = (group << 8U) | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            out += i + j <= bytes.size() ? digits[(group >> (18U - 6U * j)) & 63U] : '=';
    }
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

}  // namespace ashimpact::report
