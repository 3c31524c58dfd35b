// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Removes a plain number from the front of `text`; none if there is no finite one.
std::optional<double> take_number(std::string_view& text) {
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
    double value = 0;
    const bool read = take_decimal(text, value) == std::errc{} && std::isfinite(value);
    return read ? std::optional(value) : std::nullopt;
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
    return whole_decimal(unit).value_or(0);
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

/// Position and length of "+-", "+/-" or "±" in a text; the end and 0 if there is none.
std::pair<std::size_t, std::size_t> plus_minus_in(std::string_view text) {
    for (const std::string_view sign : {"+-", "+/-", "\u00b1"})
        if (const auto found = text.find(sign); found != std::string_view::npos) return {found, sign.size()};
    return {text.size(), 0};
}

/// Where the uncertainty in the last digits of a number ends, as in "60(3) um"; 0 without one.
std::size_t end_of_last_digits(std::string_view text) {
    const auto open = text.find('(');
    const auto close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || open == 0 || close < open)
        return 0;
    return read_number(text.substr(0, close + 1)) ? close + 1 : 0;
}

/// "60(3) um"; @p end is behind the bracket.
Quantity read_last_digits(const std::string& text, std::size_t end, Dimension expected) {
    const PrintedNumber number = read_number(std::string_view(text).substr(0, end)).value();
    const std::string rest = text.substr(end);
    const std::string unit(trimmed(rest).empty() ? si_unit(expected) : trimmed(rest));
    Quantity quantity = make_quantity(to_si(number.value, unit, expected), expected);
    if (number.standard_uncertainty)
        quantity.standard_uncertainty = to_si(*number.standard_uncertainty, unit, expected);
    return quantity;
}

/// "60 um", "60 +- 3 um", "60 um +- 3 um", "60 um +- 5 %", "60(3) um".
Quantity read_text(const std::string& text, Dimension expected) {
    if (const std::size_t end = end_of_last_digits(text)) return read_last_digits(text, end, expected);
    const auto [place, length] = plus_minus_in(text);
    if (length == 0) return make_quantity(parse_quantity(text, expected), expected);
    if (const std::string remedy = remedy_for_commas(text); !remedy.empty())
        throw InputError(
            in_quotes(text) + " has a decimal comma, " + remedy,
            with_article(dimension_name(expected)) + " [" + std::string(si_unit(expected)) + "]");
    const std::string left(trimmed(std::string_view(text).substr(0, place)));
    const std::string right(trimmed(std::string_view(text).substr(place + length)));
    const bool left_has_unit = left.find_first_not_of("+-.0123456789eE") != std::string::npos;
    const auto unit_at = std::min(right.find_first_not_of("+-.0123456789eE"), right.size());
    if (left_has_unit && unit_at == right.size())
        throw InputError("the uncertainty of " + in_quotes(text) + " has no unit",
                         in_quotes("60 +- 3 um") + " or " + in_quotes("60 um +- 5 %"));
    const double value = parse_quantity(left_has_unit ? left : left + " " + right.substr(unit_at), expected);
    const bool relative = expected != Dimension::fraction && left_has_unit && right.ends_with('%');
    const double uncertainty = relative ? std::abs(value) * parse_quantity(right, Dimension::fraction)
                                        : parse_quantity(right, expected);
    if (uncertainty < 0)
        throw InputError("the uncertainty of \"" + text + "\" is below zero", "zero or more");
    return make_quantity(value, expected, uncertainty);
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

Quantity make_quantity(double value, Dimension dimension, std::optional<double> standard_uncertainty) {
    return {.value = value,
            .unit = std::string(si_unit(dimension)),
            .standard_uncertainty = standard_uncertainty};
}

void require_uncertainty(const Quantity& quantity, Dimension dimension) {
    const double most = dimension == Dimension::fraction ? std::max(1.0, std::abs(quantity.value)) : 1e40;
    if (quantity.standard_uncertainty.value_or(0) > most)
        throw InputError("a standard uncertainty of " + shortest(*quantity.standard_uncertainty),
                         dimension == Dimension::fraction ? "0 to 1, or up to the value" : "0 to 1e40 in SI");
}

Quantity quantity_of_text(const std::string& text, Dimension expected) {
    Quantity quantity = read_text(text, expected);
    require_uncertainty(quantity, expected);
    return quantity;
}

}  // namespace ashimpact
