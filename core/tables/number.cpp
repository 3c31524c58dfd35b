// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/number.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/tables/vocabulary.hpp"
#include "core/text/decimal.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Removes a plain number from the front of `text`; none if there is no finite one.
std::optional<double> take_number(std::string_view& text) {
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, status] = decimal::read(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

/// Value of one unit in the last place of a printed number: 0.01 for "12.34", 1 for "12", 0.1 for "2.54e1".
double last_place(std::string_view printed) {
    const auto exponent = std::min(printed.find_first_of("eE"), printed.size());
    std::string unit(printed.substr(0, exponent));
    for (char& c : unit)
        if (c >= '0' && c <= '9') c = '0';
    const auto last = unit.rfind('0');
    if (last == std::string::npos) return 0;
    unit[last] = '1';
    unit.erase(0, unit.find_first_not_of("+-"));
    unit += printed.substr(exponent);
    double value = 0;
    decimal::read(unit.data(), unit.data() + unit.size(), value);
    return value;
}

std::optional<double> take_uncertainty(std::string_view& text, std::string_view printed) {
    if (text.starts_with('(')) {
        text.remove_prefix(1);
        const bool own_point = text.substr(0, text.find(')')).find('.') != std::string_view::npos;
        const auto uncertainty = take_number(text);
        if (!uncertainty || !text.starts_with(')')) return std::nullopt;
        text.remove_prefix(1);
        return own_point ? *uncertainty : *uncertainty * last_place(printed);
    }
    for (const std::string_view sign : {"+-", "+/-", "\u00b1"}) {
        if (!text.starts_with(sign)) continue;
        text.remove_prefix(sign.size());
        text = trimmed(text);
        return take_number(text);
    }
    return std::nullopt;
}

}  // namespace

std::optional<PrintedNumber> read_number(std::string_view text, bool decimal_comma) {
    std::string plain(trimmed(text));
    if (decimal_comma) std::replace(plain.begin(), plain.end(), ',', '.');
    std::string_view rest = plain;
    PrintedNumber number;
    const auto take_per_cent = [&] {
        rest = trimmed(rest);
        if (!rest.starts_with('%')) return;
        number.per_cent = true;
        rest = trimmed(rest.substr(1));
    };
    const auto value = take_number(rest);
    if (!value) return std::nullopt;
    number.value = *value;
    const std::string_view printed(plain.data(), static_cast<std::size_t>(rest.data() - plain.data()));
    take_per_cent();
    if (!rest.empty()) {
        const auto uncertainty = take_uncertainty(rest, printed);
        if (!uncertainty || *uncertainty < 0) return std::nullopt;
        if (*uncertainty > 0) number.standard_uncertainty = uncertainty;
        take_per_cent();
    }
    if (!rest.empty()) return std::nullopt;
    return number;
}

bool says_no_number(std::string_view text) {
    static const WordLists words("no number", all_marks);
    const std::string_view word = trimmed(text);
    return word.starts_with('<') || words.holds(word);
}

}  // namespace ashimpact
