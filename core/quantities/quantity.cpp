// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/json/document.hpp"
#include "core/tables/number.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

double finite_number(const Json& node, const std::string& key) {
    if (!node.at(key).is_number())
        throw InputError("not a number" + (node.at(key).is_string()
                                               ? remedy_for_number_in_quotes(node.at(key).get<std::string>())
                                               : ""),
                         "a finite number")
            .at("/" + key);
    const auto value = node.at(key).get<double>();
    if (!std::isfinite(value)) throw InputError("not finite", "a finite number").at("/" + key);
    return value;
}

Quantity read_object(const Json& node, Dimension expected) {
    for (const auto& [key, _] : node.items())
        if (key != "value" && key != "unit" && key != "standard_uncertainty")
            throw InputError("unknown key " + in_quotes(key), "value, unit, standard_uncertainty")
                .at("/" + key);
    const bool plain = expected == Dimension::fraction && !node.contains("unit");  // a number needs no unit
    for (const auto* key : {"value", "unit"})
        if (!node.contains(key) && !(plain && key == std::string_view("unit")))
            throw InputError("the key \"" + std::string(key) + "\" is missing",
                             "value, unit, standard_uncertainty");
    if (!plain && !node.at("unit").is_string())
        throw InputError("not a string", "a unit of " + std::string(dimension_name(expected))).at("/unit");
    const std::string unit = plain ? "1" : node.at("unit").get<std::string>();
    Quantity quantity = make_quantity(to_si(finite_number(node, "value"), unit, expected), expected);
    if (!node.contains("standard_uncertainty")) return quantity;
    const double uncertainty = finite_number(node, "standard_uncertainty");
    if (uncertainty < 0)
        throw InputError("a standard uncertainty below zero", "zero or more").at("/standard_uncertainty");
    quantity.standard_uncertainty = to_si(uncertainty, unit, expected);
    return quantity;
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

/// Refuses an uncertainty that makes the value meaningless. @throws InputError
void require_uncertainty(const Quantity& quantity, Dimension dimension) {
    const double most = dimension == Dimension::fraction ? std::max(1.0, std::abs(quantity.value)) : 1e40;
    if (quantity.standard_uncertainty.value_or(0) > most)
        throw InputError("a standard uncertainty of " + shortest(*quantity.standard_uncertainty),
                         dimension == Dimension::fraction ? "0 to 1, or up to the value" : "0 to 1e40 in SI");
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

Quantity make_quantity(double value, Dimension dimension, std::optional<double> standard_uncertainty) {
    return {.value = value,
            .unit = std::string(si_unit(dimension)),
            .standard_uncertainty = standard_uncertainty};
}

Quantity quantity_of_text(const std::string& text, Dimension expected) {
    Quantity quantity = read_text(text, expected);
    require_uncertainty(quantity, expected);
    return quantity;
}

Quantity read_quantity(const nlohmann::ordered_json& node, Dimension expected) {
    if (node.is_string()) return quantity_of_text(node.get<std::string>(), expected);
    if (node.is_number())
        return make_quantity(to_si(node.get<double>(), si_unit(expected), expected), expected);
    if (!node.is_object())
        throw InputError("not a quantity", "a number in " + std::string(si_unit(expected)) +
                                               R"(, a string with its unit, or {"value", "unit"})");
    Quantity quantity = read_object(node, expected);
    at_place("/standard_uncertainty", [&] { require_uncertainty(quantity, expected); });
    return quantity;
}

void to_json(nlohmann::ordered_json& node, const Quantity& quantity) {
    node = Json{{"value", quantity.value}, {"unit", quantity.unit}};
    if (quantity.standard_uncertainty) node["standard_uncertainty"] = *quantity.standard_uncertainty;
}

}  // namespace ashimpact
