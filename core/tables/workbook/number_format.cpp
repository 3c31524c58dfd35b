// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/workbook/number_format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>

#include "core/text/text.hpp"

namespace ashimpact {

bool has_meaning(std::string_view text) {
    return std::ranges::any_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return std::isalpha(byte) != 0 || byte >= 0x80 ||
               std::string_view("<>~%*").find(c) != std::string_view::npos;
    });
}

namespace {

/// Whether brackets of a code name a colour or a script of digits, which change no number.
bool is_harmless(std::string_view inside) {
    constexpr std::array<std::string_view, 10> words{"black", "blue",   "cyan",  "green", "magenta",
                                                     "red",   "yellow", "white", "color", "dbnum"};
    const std::string text = lower_case(inside);
    return std::ranges::find(words, text.substr(0, text.find_first_of("0123456789 "))) != words.end();
}

/// A part of a code in square brackets: a condition, a currency, a time; colours and languages are nothing.
void take_brackets(std::string_view inside, FormatSection& section, std::string& literal) {
    if (inside.empty()) return;
    if (std::string_view("<>=").find(inside.front()) != std::string_view::npos)
        section.condition = inside;
    else if (inside.front() == '$')
        literal += inside.substr(1, inside.find('-') - 1);
    else if (inside.find_first_not_of("hmsHMS") == std::string_view::npos)
        section.format = Format::date;
    else if (!is_harmless(inside))
        section.format = Format::unknown;
}

/// Whether what stands between two digits of a code separates groups, decimals, an exponent or a fraction.
bool may_be_between_digits(std::string_view text) {
    constexpr std::array<std::string_view, 13> known{"",   ".",  ",",  " ",      "'",      "/",     "E+",
                                                     "E-", "e+", "e-", "\u00a0", "\u202f", "\u2019"};
    return std::ranges::find(known, text) != known.end();
}

}  // namespace

NumberFormat format_of_code(std::string_view code) {
    NumberFormat format(1);
    std::string literal;
    std::string between;  // digits of the section
    const auto end_literal = [&] {
        FormatSection& section = format.back();
        // Other sections have them in place of the sign of their numbers.
        const bool changes_number = format.size() == 1 && section.condition.empty() &&
                                    literal.find_first_of("-(0123456789") != std::string::npos;
        if (has_meaning(literal) || changes_number)
            (section.has_number ? section.suffix : section.prefix) += literal;
        literal.clear();
    };
    const auto end_section = [&] {
        end_literal();
        FormatSection& section = format.back();
        const bool is_date = section.format == Format::date;  // whose letters may be quoted digits
        if (!is_date && std::ranges::count(between, '%') > 1) section.format = Format::unknown;
        const std::string_view suffix = trimmed(section.suffix);  // "(4)", of the last digits shown
        if (suffix.starts_with('(') && suffix.find_first_of("0123456789") != std::string_view::npos)
            section.format = Format::unknown;
        between.clear();
    };
    for (std::size_t i = 0; i < code.size(); ++i) {
        const char c = code[i];
        FormatSection& section = format.back();
        const std::size_t before = literal.size();
        if (c == '"' || c == '[') {
            const auto end = std::min(code.find(c == '"' ? '"' : ']', i + 1), code.size());
            const std::string_view inside = code.substr(i + 1, end - i - 1);
            if (c == '"')
                literal += inside;
            else
                take_brackets(inside, section, literal);
            i = end;
        } else if (c == '\\') {
            literal += code.substr(++i, 1);
        } else if (c == '_' || c == '*') {
            ++i;  // the width of the next one, or the next one as filling
        } else if (c == ';') {
            end_section();
            format.emplace_back();
            continue;
        } else if (std::string_view("0#?@").find(c) != std::string_view::npos) {
            if (section.has_number && section.format != Format::date && !may_be_between_digits(between))
                section.format = Format::unknown;
            end_literal();
            between.clear();
            section.has_number = true;
        } else if (c == ',' && section.has_number) {
            between += c;
            section.in_thousands =
                i + 1 == code.size() || std::string_view("0#?,").find(code[i + 1]) == std::string_view::npos;
        } else if (c == '%') {
            between += c;
            if (section.format != Format::unknown) section.format = Format::per_cent;
        } else if (lower_case(code.substr(i, 7)) == "general") {
            end_literal();
            section.has_number = true;
            i += 6;
        } else if ((c == 'E' || c == 'e') && section.has_number && i + 1 < code.size() &&
                   (code[i + 1] == '+' || code[i + 1] == '-')) {
            between += code.substr(i++, 2);
        } else if (std::string_view("dmyhsDMYHS").find(c) != std::string_view::npos) {
            section.format = Format::date;
        } else if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            if (section.format != Format::date) section.format = Format::unknown;  // unlike "yyyy AM/PM"
        } else if (std::string_view("<>~/").find(c) != std::string_view::npos ||
                   static_cast<unsigned char>(c) >= 0x80 || (!section.has_number && (c == '-' || c == '('))) {
            literal += c;
        } else {
            between += c;
        }
        const std::string_view text = std::string_view(literal).substr(std::min(before, literal.size()));
        const bool is_quoted = c == '"' || c == '\\' || c == '[';  // a point in quotes separates no decimals
        between += is_quoted && text.find_first_of(".,/") != std::string_view::npos ? "\"" : text;
    }
    end_section();
    return format;
}

namespace {

/// Whether the condition of a section holds.
bool holds(std::string_view condition, double number) {
    const auto digits = condition.find_first_not_of("<>=");
    const auto limit = digits == std::string_view::npos
                           ? std::nullopt
                           : whole_decimal(std::string(condition.substr(digits)));
    if (!limit) return false;
    const std::string_view sign = condition.substr(0, digits);
    return sign == "<"    ? number < *limit
           : sign == "<=" ? number <= *limit
           : sign == ">"  ? number > *limit
           : sign == ">=" ? number >= *limit
           : sign == "="  ? number == *limit
                          : number != *limit;
}

}  // namespace

const FormatSection& section_of(const NumberFormat& format, double number) {
    if (std::ranges::any_of(format, [](const FormatSection& each) { return !each.condition.empty(); })) {
        for (const FormatSection& section : format)
            if (section.condition.empty() || holds(section.condition, number)) return section;
        return format.front();
    }
    if (number < 0 && format.size() > 1) return format[1];
    if (number == 0 && format.size() > 2) return format[2];
    return format.front();
}

NumberFormat built_in_format(std::size_t id) {
    if (id == 9 || id == 10) return {{.format = Format::per_cent, .has_number = true}};
    const bool date =
        (id >= 14 && id <= 22) || (id >= 27 && id <= 36) || (id >= 45 && id <= 47) || (id >= 50 && id <= 58);
    const bool number =
        id <= 4 || id == 11 || id == 12 || id == 13 || (id >= 37 && id <= 44) || id == 48 || id == 49;
    return {{.format = date ? Format::date : number ? Format::number : Format::unknown, .has_number = true}};
}

}  // namespace ashimpact
