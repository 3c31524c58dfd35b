// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/unit_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/units/unit_system.hpp"

namespace ashimpact {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

bool names_a_unit(std::string_view unit) {
    if (unit == "1") return true;
    char before = ' ';
    for (const char c : unit) {
        const bool after_unit = is_letter(before) || before == '^' || before == ')';
        const bool exponent =
            is_digit(c) && (after_unit || is_digit(before) || before == '-' || before == '+');
        const bool sign = (c == '-' || c == '+') && after_unit;
        if (!exponent && !sign && !is_letter(c) &&
            std::string_view(" ./*^()_").find(c) == std::string_view::npos)
            return false;
        before = c;
    }
    return !unit.empty();
}

std::string ascii(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 23> replacements{{
        {"\u00b5", "u"},        {"\u03bc", "u"},        {"\u00b7", "."}, {"\u22c5", "."}, {"\u00d7", "."},
        {"\u2212", "-"},        {"\u207b", "-"},        {"\u2070", "0"}, {"\u00b9", "1"}, {"\u00b2", "2"},
        {"\u00b3", "3"},        {"\u2074", "4"},        {"\u2075", "5"}, {"\u2076", "6"}, {"\u2077", "7"},
        {"\u2078", "8"},        {"\u2079", "9"},        {"\u00a0", " "}, {"\u2009", " "}, {"\u202f", " "},
        {"\u00c5", "angstrom"}, {"\u212b", "angstrom"}, {"**", "^"},
    }};
    std::string plain;
    while (!text.empty()) {
        const auto* const found =
            std::find_if(replacements.begin(), replacements.end(),
                         [&](const auto& entry) { return text.starts_with(entry.first); });
        const bool replaced = found != replacements.end();
        plain += replaced ? found->second : text.substr(0, 1);
        text.remove_prefix(replaced ? found->first.size() : 1);
    }
    return plain;
}

}  // namespace ashimpact
