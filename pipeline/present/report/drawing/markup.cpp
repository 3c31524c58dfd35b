// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/markup.hpp"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace ashimpact::report {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// The code point that begins at @p at, and its length; length 0 where the bytes are not UTF-8.
struct CodePoint {
    std::uint32_t value = 0;
    std::size_t length = 0;
};

CodePoint code_point(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(at);
    if (lead < 0x80U) return {lead, 1};
    const std::size_t length = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : lead >= 0xC2U ? 2 : 0;
    if (length == 0 || lead > 0xF4U || at + length > text.size()) return {};
    std::uint32_t value = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0U) != 0x80U) return {};
        value = (value << 6U) | (byte(at + i) & 0x3FU);
    }
    const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
    const bool surrogate = value >= 0xD800 && value < 0xE000;
    if (overlong || surrogate || value > 0x10FFFF || (value & 0xFFFEU) == 0xFFFEU) return {};
    return {value, length};
}

bool is_control(std::uint32_t value) {
    return (value < 0x20 && value != '\n' && value != '\t') || (value >= 0x7F && value < 0xA0);
}

/// Width of a character over the font size.
double relative_width(std::uint32_t value) {
    if (value < 0x80) {
        const auto character = static_cast<char>(value);
        if (std::string_view("iljtfI.,:;|'!()[]/ ").find(character) != std::string_view::npos) return 0.36;
        if (std::string_view("mwMW%@").find(character) != std::string_view::npos) return 0.95;
        if (std::string_view("<>=+~^#&").find(character) != std::string_view::npos) return 0.84;
        return value >= 'A' && value <= 'Z' ? 0.72 : 0.61;
    }
    return value < 0x1100 ? 0.7 : 1.1;
}

template <class Each>
void for_each_code_point(std::string_view text, Each&& each) {
    for (std::size_t i = 0; i < text.size();) {
        const CodePoint point = code_point(text, i);
        const std::size_t length = point.length == 0 ? 1 : point.length;
        each(point, text.substr(i, length));
        i += length;
    }
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
        if (point.length == 0)
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
        else if (!is_control(point.value))
            out += bytes;
    });
    return out;
}

std::string subscripted(std::string_view label) {
    std::string out;
    for (std::size_t i = 0; i < label.size();) {
        if (label[i] != '_' || i == 0 || i + 1 == label.size() || !is_word(label[i + 1])) {
            out += escaped(label.substr(i, 1));
            if (static_cast<unsigned char>(label[i]) >= 0x80U) {  // the whole character, not its first byte
                out.resize(out.size() - replacement.size());
                const std::size_t length = std::max<std::size_t>(1, code_point(label, i).length);
                out += escaped(label.substr(i, length));
                i += length - 1;
            }
            ++i;
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
    for_each_code_point(text, [&](const CodePoint& point, std::string_view) {
        width += relative_width(point.length == 0 ? 0xFFFD : point.value);
    });
    return width * font_size;
}

std::string fitted(std::string_view text, double font_size, double most) {
    if (text_width(text, font_size) <= most) return std::string(text);
    std::string out;
    double width = font_size;  // of the ellipsis
    bool full = false;
    for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
        width += relative_width(point.length == 0 ? 0xFFFD : point.value) * font_size;
        full = full || width > most;
        if (!full) out += bytes;
    });
    return out + "…";
}

std::string isolated(std::string_view name) {
    bool plain = true;
    for (const char c : name) plain = plain && static_cast<unsigned char>(c) < 0x80U;
    return plain ? escaped(name) : "\u2068" + escaped(name) + "\u2069";
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
