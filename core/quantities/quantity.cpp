// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Removes a number from the front of `text` and returns it; none if there is no finite one.
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

/// Likewise for "+-3", "+/-3", "±3", "(0.3)" or "(3)", which counts last places of the printed value.
std::optional<double> take_uncertainty(std::string_view& text, std::string_view printed) {
    if (text.starts_with('(')) {
        text.remove_prefix(1);
        const bool has_point = text.substr(0, text.find(')')).find('.') != std::string_view::npos;
        const auto uncertainty = take_number(text);
        if (!uncertainty || !text.starts_with(')')) return std::nullopt;
        text.remove_prefix(1);
        return has_point ? *uncertainty : *uncertainty * last_place(printed);
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

/// Position behind the bracket of "60(3) um"; 0 if the text has no such uncertainty.
std::size_t end_of_bracket(std::string_view text) {
    const auto open = text.find('(');
    const auto close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || open == 0 || close < open)
        return 0;
    return read_number(text.substr(0, close + 1)) ? close + 1 : 0;
}

/// Reads "60(3) um"; @p end is the position behind the bracket.
Quantity read_with_bracket(const std::string& text, std::size_t end, Dimension expected) {
    const PrintedNumber number = read_number(std::string_view(text).substr(0, end)).value();
    const std::string rest = text.substr(end);
    const std::string unit(trimmed(rest).empty() ? si_unit(expected) : trimmed(rest));
    Quantity quantity = make_quantity(to_si(number.value, unit, expected), expected);
    if (number.standard_uncertainty)
        quantity.standard_uncertainty = difference_to_si(*number.standard_uncertainty, unit, expected);
    return quantity;
}

/// Reads "60 um", "60 +- 3 um", "60 um +- 3 um", "60 um +- 5 %" or "60(3) um".
Quantity read_text(const std::string& text, Dimension expected) {
    if (const std::size_t end = end_of_bracket(text)) return read_with_bracket(text, end, expected);
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
    const double uncertainty =
        relative ? std::abs(value) * parse_quantity(right, Dimension::fraction)
                 : parse_quantity(right, expected) - parse_quantity("0" + right.substr(unit_at), expected);
    if (expected == Dimension::fraction && !left_has_unit && right.ends_with('%') && std::abs(value) < 0.01 &&
        uncertainty > std::abs(value))
        throw InputError("in " + in_quotes(text) + " the value is " + left + " %, or " + left +
                             " with a relative uncertainty",
                         in_quotes(fmt::format("{} +- {}", shortest(value), shortest(uncertainty))) +
                             ", or the uncertainty in the unit of the value");
    if (expected == Dimension::fraction && left.ends_with('%') && right.ends_with('%'))
        refuse_two_per_cents(text, 100 * value, 100 * uncertainty, "{} +- {} %");
    if (uncertainty < 0)
        throw InputError("the uncertainty of \"" + text + "\" is below zero", "zero or more");
    return make_quantity(value, expected, uncertainty);
}

struct DisplayUnit {
    std::string_view si;
    std::string_view name;
    double factor;  ///< value of this unit [SI unit]
};

/// The largest first within each SI unit. SI units that are not listed are displayed themselves.
constexpr std::array<DisplayUnit, 36> display_units{{
    {"Pa", "GPa", 1e9},  {"Pa", "MPa", 1e6},    {"Pa", "Pa", 1},       {"m", "m", 1},
    {"m", "mm", 1e-3},   {"m", "um", 1e-6},     {"m", "nm", 1e-9},     {"m", "pm", 1e-12},
    {"s", "s", 1},       {"s", "ms", 1e-3},     {"s", "us", 1e-6},     {"s", "ns", 1e-9},
    {"kg", "kg", 1},     {"kg", "g", 1e-3},     {"kg", "mg", 1e-6},    {"kg", "ug", 1e-9},
    {"kg", "ng", 1e-12}, {"kg", "pg", 1e-15},   {"J", "J", 1},         {"J", "mJ", 1e-3},
    {"J", "uJ", 1e-6},   {"J", "nJ", 1e-9},     {"J", "pJ", 1e-12},    {"J", "fJ", 1e-15},
    {"J", "aJ", 1e-18},  {"N", "N", 1},         {"N", "mN", 1e-3},     {"N", "uN", 1e-6},
    {"N", "nN", 1e-9},   {"m/s", "m/s", 1},     {"m/s", "mm/s", 1e-3}, {"m/s", "um/s", 1e-6},
    {"N s", "N s", 1},   {"N s", "uN s", 1e-6}, {"N s", "nN s", 1e-9}, {"N s", "pN s", 1e-12},
}};

/// The largest unit in which the number is at least 1, or 0.01 for velocities: 0.05 m/s, not 50 mm/s. The SI
/// unit itself if it is not listed or the value is 0.
DisplayUnit display_unit(double value, std::string_view si) {
    const double least = si == "m/s" ? 1e-2 : 1.0;
    DisplayUnit chosen{si, si, 1};
    if (value == 0) return chosen;
    for (const DisplayUnit& unit : display_units) {
        if (unit.si != si) continue;
        chosen = unit;
        if (std::abs(value) >= least * unit.factor) break;
    }
    return chosen;
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
    constexpr std::array positive{Dimension::length, Dimension::pressure, Dimension::density, Dimension::mass,
                                  Dimension::energy_per_area};
    constexpr double most_of_value = 1e3;
    if (quantity.value > 0 && quantity.standard_uncertainty.value_or(0) > most_of_value * quantity.value &&
        std::ranges::find(positive, dimension) != positive.end())
        throw InputError(
            fmt::format("a standard uncertainty of {}, {:.3g} times the value: it may be in another unit",
                        readable(*quantity.standard_uncertainty, quantity.unit),
                        *quantity.standard_uncertainty / quantity.value),
            "the unit of the value");
}

void require_certain(const std::optional<double>& uncertainty, const std::string& subject,
                     const std::string& instead) {
    if (uncertainty) throw InputError(subject + "states an uncertainty, which nothing here uses", instead);
}

void refuse_two_per_cents(std::string_view text, double value, double uncertainty, std::string_view form) {
    const double of_whole = value * uncertainty / 100;
    if (value == 0 || value == 100 || uncertainty == 0) return;
    const auto written = [&](double u) {
        return in_quotes(fmt::format(fmt::runtime(form), readable_number(value, 12), readable_number(u, 6)));
    };
    throw InputError(
        fmt::format("in {} the uncertainty is {} % of the whole, or of the value, {} % of the whole",
                    in_quotes(text), readable_number(uncertainty, 6), readable_number(of_whole, 6)),
        written(uncertainty) + " or " + written(of_whole));
}

void refuse_thousands_point(std::string_view text, PointDigits digits) {
    const std::string_view number = text.substr(0, text.find_first_not_of("0123456789."));
    const std::size_t mark = number.find('.');
    const bool may_group = mark != std::string_view::npos && mark > 0 && mark <= 3 &&
                           number.size() == mark + 4 && number.front() != '0' &&
                           number.find_first_not_of(digits == PointDigits::zeros ? "0" : "0123456789",
                                                    mark + 1) == std::string_view::npos;
    if (!may_group) return;
    const std::string grouped = std::string(number.substr(0, mark)) + std::string(number.substr(mark + 1));
    throw InputError(in_quotes(number) + " is " + std::string(number) + " or " + grouped,
                     grouped + ", or " + std::string(number) + "0");
}

/// Whether a text ends with a unit in which plausible numbers often are thousands: E in N/mm2, velocities in
/// mm/s.
static bool often_holds_thousands(std::string_view text) {
    constexpr std::array<std::string_view, 22> units{
        "MPa",     "N/mm2", "N/mm\u00b2", "N/mm^2", "ppm",   "mg/kg",     "mm/s",       "mm s-1",
        "mm s^-1", "Pa s",  "Pa\u00b7s",  "nm",     "rpm",   "mg/m3",     "mg/m\u00b3", "mg/Nm3",
        "C",       "K",     "mg/s",       "cm/s",   "MJ/m3", "MJ/m\u00b3"};
    return std::ranges::any_of(units, [&](std::string_view unit) { return text.ends_with(unit); });
}

Quantity quantity_of_text(const std::string& text, Dimension expected) {
    refuse_thousands_point(trimmed(text),
                           often_holds_thousands(trimmed(text)) ? PointDigits::any : PointDigits::zeros);
    Quantity quantity = read_text(text, expected);
    require_uncertainty(quantity, expected);
    return quantity;
}

std::string readable_number(double value, int digits) {
    return fmt::format("{:.{}g}", value, digits);
}

std::string readable(double value, std::string_view unit) {
    if (unit == "1") return readable_number(value);
    const DisplayUnit shown = display_unit(value, unit);
    return fmt::format("{} {}", readable_number(value / shown.factor), shown.name);
}

std::string readable(const Quantity& quantity) {
    constexpr double least_relative = 1e-4;
    if (!quantity.standard_uncertainty ||
        !(std::abs(*quantity.standard_uncertainty) > least_relative * std::abs(quantity.value)))
        return readable(quantity.value, quantity.unit);
    const DisplayUnit shown = display_unit(quantity.value, quantity.unit);
    const std::string unit = shown.name == "1" ? "" : " " + std::string(shown.name);
    const double value = quantity.value / shown.factor;
    const double uncertainty = *quantity.standard_uncertainty / shown.factor;
    // Decimals that show two digits of the uncertainty after rounding; negative: zeros before the point.
    const std::string rounded = fmt::format("{:.1e}", uncertainty);
    const int decimals = 1 - std::stoi(rounded.substr(rounded.find('e') + 1));
    constexpr int most_decimals = 6;
    if (decimals > most_decimals || decimals < -3)
        return fmt::format("{} +- {}{}", readable_number(value), readable_number(uncertainty, 2), unit);
    const double step = std::pow(10.0, std::max(-decimals, 0));
    const auto text = [&](double number) {
        return decimals > 0 ? fmt::format("{:.{}f}", number, decimals)
                            : fmt::format("{:.0f}", step * std::round(number / step));
    };
    return fmt::format("{} +- {}{}", text(value), text(uncertainty), unit);
}

std::string uncertainty_legend(std::string_view text) {
    return text.find("+-") == std::string_view::npos ? "" : "+-: standard uncertainty.\n";
}

}  // namespace ashimpact
