// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Keys for the origin of a quantity; see docs/case.md.
constexpr std::array<std::string_view, 2> origin_keys{"origin", "source"};

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
    quantity.standard_uncertainty = difference_to_si(uncertainty, unit, expected);
    constexpr double hardly = 1e-5, usual = 1e-4;  // of the value
    const double size = std::abs(quantity.value);
    if (*quantity.standard_uncertainty < hardly * size && uncertainty > usual * size && uncertainty < size)
        throw InputError("is " + shortest(uncertainty) + " " + unit + ", or " + shortest(uncertainty) + " " +
                             std::string(si_unit(expected)),
                         "a number in the unit of the value, " + unit)
            .at("/standard_uncertainty");
    return quantity;
}

}  // namespace

Quantity read_quantity(const Json& node, Dimension expected) {
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

void to_json(Json& node, const Quantity& quantity) {
    node = Json{{"value", quantity.value}, {"unit", quantity.unit}};
    if (quantity.standard_uncertainty) node["standard_uncertainty"] = *quantity.standard_uncertainty;
}

Quantity shown_quantity(const Json& quantity) {
    Quantity shown{.value = quantity.at("value"), .unit = quantity.at("unit")};
    if (quantity.contains("standard_uncertainty") && quantity.at("standard_uncertainty").is_number())
        shown.standard_uncertainty = quantity.at("standard_uncertainty").get<double>();
    return shown;
}

void View::fail(const std::string& problem, const std::string& allowed) const {
    const InputError error(problem, allowed);
    throw pointer_.empty() ? error : error.at(pointer_);
}

bool View::has(std::string_view key) const {
    return find(key).has_value();
}

std::optional<View> View::find(std::string_view key) const {
    if (!value_->is_object()) fail("is not an object", "an object");
    const auto found = value_->find(key);
    if (found == value_->end() || found->is_null()) return std::nullopt;
    return View(*found, child_pointer(pointer_, key));
}

View View::at(std::string_view key) const {
    if (auto found = find(key)) return *std::move(found);
    fail("\"" + std::string(key) + "\" is missing", "an object with this key");
}

std::vector<View> View::elements() const {
    if (!value_->is_array()) fail("is not an array", "an array");
    std::vector<View> elements;
    elements.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i)
        elements.push_back(View((*value_)[i], child_pointer(pointer_, i)));
    return elements;
}

void View::require_keys(std::initializer_list<std::string_view> allowed) const {
    const std::vector<std::string> known(allowed.begin(), allowed.end());
    for (const Member& member : members())
        if (std::find(known.begin(), known.end(), member.key) == known.end())
            member.value.fail("unknown key " + in_quotes(member.key) + did_you_mean(member.key, known),
                              joined(known));
}

std::vector<View::Member> View::members() const {
    if (!value_->is_object()) fail("is not an object", "an object");
    std::vector<Member> members;
    for (auto member = value_->begin(); member != value_->end(); ++member)
        members.push_back({member.key(), View(*member, child_pointer(pointer_, member.key()))});
    return members;
}

std::string View::text() const {
    if (!value_->is_string()) fail("is not a string", "a string");
    auto text = value_->get<std::string>();
    if (text.find('\0') != std::string::npos) fail("holds a NUL character", "a text without it");
    return text;
}

std::vector<std::string> View::texts() const {
    std::vector<std::string> texts;
    for (const View& element : elements()) texts.push_back(element.text());
    return texts;
}

bool View::truth() const {
    if (!value_->is_boolean()) fail("is not true or false", "true, false");
    return value_->get<bool>();
}

int View::integer() const {
    constexpr double most = std::numeric_limits<int>::max();
    const double number = value_->is_number() ? value_->get<double>() : 0.5;
    if (number != std::floor(number) || std::abs(number) > most) fail("is not an integer", "an integer");
    return static_cast<int>(number);
}

Quantity View::quantity(Dimension dimension) const {
    return at_place(pointer_, [&] {
        if (!value_->is_object()) return read_quantity(*value_, dimension);
        Json plain = *value_;
        for (const std::string_view key : origin_keys) plain.erase(std::string(key));
        return read_quantity(plain, dimension);
    });
}

double View::number(Dimension dimension) const {
    return quantity(dimension).value;
}

double View::certain_number(Dimension dimension, const std::string& instead) const {
    const Quantity read = quantity(dimension);
    at_place(pointer_, [&] { require_certain(read.standard_uncertainty, "", instead); });
    return read.value;
}

std::vector<double> View::column(Dimension dimension) const {
    const bool with_unit = value_->is_object();
    const View values = with_unit ? at("values") : *this;
    const std::string unit = with_unit ? at("unit").text() : std::string(si_unit(dimension));
    std::vector<double> column;
    std::optional<SiConversion> conversion;
    for (const View& element : values.elements()) {
        if (!element.json().is_number())
            element.fail(
                "is not a number" + (element.is_string() ? remedy_for_number_in_quotes(element.text()) : ""),
                "a number");
        column.push_back(at_place(element.pointer(), [&] {
            if (!conversion) conversion.emplace(unit, dimension);
            return (*conversion)(element.json().get<double>());
        }));
    }
    return column;
}

Quantity positive_quantity(const View& node, std::string_view name, Dimension dimension) {
    Quantity quantity = node.quantity(dimension);
    at_place(node.pointer(), [&] { require_positive(name, quantity.value, dimension); });
    return quantity;
}

Json quantity_json(double value, Dimension dimension) {
    return quantity_json(value, si_unit(dimension));
}

Json quantity_json(double value, std::string_view unit) {
    return {{"value", value}, {"unit", unit}};
}

Json quantity_json(const std::optional<double>& value, Dimension dimension) {
    return value ? quantity_json(*value, dimension) : Json(nullptr);
}

Json column_json(const std::vector<double>& values, Dimension dimension) {
    return {{"values", values}, {"unit", si_unit(dimension)}};
}

void require_agreement(const View& value, double expected, Dimension dimension, const std::string& problem,
                       const std::string& others) {
    constexpr double same_number = 1e-9;
    const double number = value.number(dimension);
    if (std::abs(number - expected) <= same_number * std::max(std::abs(number), std::abs(expected))) return;
    value.fail(problem, shortest(expected) + " " + std::string(si_unit(dimension)) + ", or edit " + others +
                            " as well");
}

}  // namespace ashimpact
