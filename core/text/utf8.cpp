// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/utf8.hpp"

#include <algorithm>
#include <array>

#include "core/text/text.hpp"

namespace ashimpact {

namespace {

unsigned char byte_of(char c) {
    return static_cast<unsigned char>(c);
}

/// Whether a byte is a continuation byte of a character.
bool continues(char c) {
    return (byte_of(c) & 0xc0U) == 0x80U;
}

using Spelling = std::pair<std::string_view, std::string_view>;

/// Composed letters first, then combining marks as macOS writes them: "u" and U+0308 is "ue", too.
constexpr std::array<Spelling, 74> spellings{{
    {"ä", "ae"},       {"ö", "oe"},       {"ü", "ue"},       {"Ä", "Ae"},       {"Ö", "Oe"},
    {"Ü", "Ue"},       {"ß", "ss"},       {"ẞ", "SS"},       {"æ", "ae"},       {"œ", "oe"},
    {"ø", "o"},        {"å", "a"},        {"à", "a"},        {"á", "a"},        {"â", "a"},
    {"ã", "a"},        {"ç", "c"},        {"è", "e"},        {"é", "e"},        {"ê", "e"},
    {"ë", "e"},        {"ì", "i"},        {"í", "i"},        {"î", "i"},        {"ï", "i"},
    {"ñ", "n"},        {"ò", "o"},        {"ó", "o"},        {"ô", "o"},        {"õ", "o"},
    {"ù", "u"},        {"ú", "u"},        {"û", "u"},        {"À", "A"},        {"Ç", "C"},
    {"È", "E"},        {"É", "E"},        {"Ê", "E"},        {"Î", "I"},        {"Ô", "O"},
    {"a\u0308", "ae"}, {"o\u0308", "oe"}, {"u\u0308", "ue"}, {"A\u0308", "Ae"}, {"O\u0308", "Oe"},
    {"U\u0308", "Ue"}, {"\u0300", ""},    {"\u0301", ""},    {"\u0302", ""},    {"\u0303", ""},
    {"\u0308", ""},    {"\u030a", ""},    {"\u0327", ""},    {"α", "alpha"},    {"β", "beta"},
    {"γ", "gamma"},    {"θ", "theta"},    {"σ", "sigma"},    {"Σ", "sum"},      {"±", "+-"},
    {"²", "2"},        {"³", "3"},        {"₀", "0"},        {"₁", "1"},        {"₂", "2"},
    {"₃", "3"},        {"₄", "4"},        {"₅", "5"},        {"₆", "6"},        {"₇", "7"},
    {"₈", "8"},        {"₉", "9"},        {"·", "."},        {"\u00a0", " "},
}};

}  // namespace

bool Character::is_control() const {
    return (code_point < 0x20 && code_point != '\n' && code_point != '\t') ||
           (code_point >= 0x7f && code_point < 0xa0);
}

Character first_character(std::string_view text) {
    const Character invalid{.bytes = text.substr(0, 1)};
    const unsigned char lead = byte_of(text.front());
    if (lead < 0x80U) return {text.substr(0, 1), lead, true};
    const std::size_t length = lead >= 0xf0U ? 4 : lead >= 0xe0U ? 3 : 2;
    if (lead < 0xc2U || lead > 0xf4U || text.size() < length) return invalid;
    char32_t value = lead & (0xffU >> (length + 1));
    for (const char c : text.substr(1, length - 1)) {
        if (!continues(c)) return invalid;
        value = (value << 6U) | (byte_of(c) & 0x3fU);
    }
    const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
    const bool surrogate = value >= 0xd800 && value < 0xe000;
    return overlong || surrogate || value > 0x10ffff ? invalid
                                                     : Character{text.substr(0, length), value, true};
}

bool is_utf8(std::string_view text) {
    bool valid = true;
    for_each_character(text, [&](const Character& character) { valid = valid && character.valid; });
    return valid;
}

bool is_ascii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return byte_of(c) < 0x80U; });
}

std::size_t width_of(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

std::string_view first_characters(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    while (end < text.size() && (continues(text[end]) || count-- > 0)) ++end;
    return text.substr(0, end);
}

std::string_view whole_start(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    std::size_t end = most;
    while (end > 0 && most - end < 3 && continues(text[end])) --end;
    return text.substr(0, end);
}

std::string_view whole_end(std::string_view text, std::size_t most) {
    std::size_t start = text.size() > most ? text.size() - most : 0;
    for (int i = 0; i < 3 && start < text.size() && continues(text[start]); ++i) ++start;
    return text.substr(start);
}

std::string from_latin1(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        if (byte_of(c) < 0x80U) {
            text += c;
            continue;
        }
        text += static_cast<char>(0xc0U | (byte_of(c) >> 6U));
        text += static_cast<char>(0x80U | (byte_of(c) & 0x3fU));
    }
    return text;
}

std::string replaced(std::string_view text, Replacements pairs) {
    std::string result;
    while (!text.empty()) {
        const auto found = std::find_if(pairs.begin(), pairs.end(),
                                        [&](const auto& pair) { return text.starts_with(pair.first); });
        result += found != pairs.end() ? found->second : text.substr(0, 1);
        text.remove_prefix(found != pairs.end() ? found->first.size() : 1);
    }
    return result;
}

std::string transliterated(std::string_view text) {
    return is_ascii(text) ? std::string(text) : replaced(text, spellings);
}

std::string word_key(std::string_view text, std::string_view kept) {
    std::string key = lower_case(transliterated(text));
    std::erase_if(key, [&](char c) {
        const bool is_letter_or_digit =
            (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || byte_of(c) >= 0x80U;
        return !is_letter_or_digit && kept.find(c) == std::string_view::npos;
    });
    return key;
}

}  // namespace ashimpact
