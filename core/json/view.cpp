// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Keys for the origin of a quantity; see docs/case.md.
constexpr std::array<std::string_view, 2> origin_keys{"origin", "source"};

}  // namespace

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
    if (!value_->is_number_integer()) fail("is not an integer", "an integer");
    return value_->get<int>();
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

}  // namespace ashimpact
