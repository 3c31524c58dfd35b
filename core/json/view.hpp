// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "core/quantities/quantity.hpp"

namespace ashimpact {

/// Reads a quantity from a case or an artifact: a bare number (SI), a string with its unit ("44 um"), or
/// {"value", "unit", "standard_uncertainty"} in any convertible unit. Returns it in SI.
/// Errors: InputError, with the JSON pointer relative to `node` as its place.
[[nodiscard]] Quantity read_quantity(const Json& node, Dimension expected);

/// A quantity of an artifact in the unit written there, not converted to SI.
[[nodiscard]] Quantity shown_quantity(const Json& quantity);

/// Writes {"value", "unit"}, and "standard_uncertainty" where there is one.
void to_json(Json& node, const Quantity& quantity);

/// A value of a document with its JSON pointer. Every read throws InputError with that pointer as its place.
/// The document must outlive its views.
class View {
  public:
    explicit View(const Json& document) : View(document, {}) {}

    [[nodiscard]] const Json& json() const { return *value_; }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] bool is_object() const { return value_->is_object(); }
    [[nodiscard]] bool is_string() const { return value_->is_string(); }
    [[nodiscard]] bool has(std::string_view key) const;

    /// The member of that name. @throws InputError if it is missing
    [[nodiscard]] View at(std::string_view key) const;
    /// The member of that name, if it is there and not null.
    [[nodiscard]] std::optional<View> find(std::string_view key) const;
    /// The elements of an array.
    [[nodiscard]] std::vector<View> elements() const;
    /// Refuses keys other than these. @throws InputError naming the nearest one
    void require_keys(std::initializer_list<std::string_view> allowed) const;
    /// One member of an object.
    struct Member;
    [[nodiscard]] std::vector<Member> members() const;

    [[nodiscard]] std::string text() const;
    /// The strings of an array.
    [[nodiscard]] std::vector<std::string> texts() const;
    [[nodiscard]] bool truth() const;
    [[nodiscard]] int integer() const;
    /// A quantity in SI; its keys "origin" and "source" are ignored.
    [[nodiscard]] Quantity quantity(Dimension dimension) const;
    /// The value of a quantity [SI unit of the dimension].
    [[nodiscard]] double number(Dimension dimension) const;
    /// The same of a quantity that states no uncertainty. @param instead where an uncertainty belongs
    [[nodiscard]] double certain_number(Dimension dimension, const std::string& instead) const;
    /// The values of a column, {"values": [..], "unit"} or an array in SI [SI unit of the dimension].
    [[nodiscard]] std::vector<double> column(Dimension dimension) const;

    [[noreturn]] void fail(const std::string& problem, const std::string& allowed = {}) const;

  private:
    View(const Json& value, std::string pointer) : value_(&value), pointer_(std::move(pointer)) {}

    const Json* value_;
    std::string pointer_;
};

/// A quantity > 0 in SI. @throws InputError with its pointer
[[nodiscard]] Quantity positive_quantity(const View& node, std::string_view name, Dimension dimension);

struct View::Member {
    std::string key;
    View value;
};

/// {"value", "unit"} of a value in SI.
[[nodiscard]] Json quantity_json(double value, Dimension dimension);
[[nodiscard]] Json quantity_json(double value, std::string_view unit);

/// The same, or null where there is none.
[[nodiscard]] Json quantity_json(const std::optional<double>& value, Dimension dimension);

/// {"values", "unit"} of values in SI.
[[nodiscard]] Json column_json(const std::vector<double>& values, Dimension dimension);

/// Checks that a value agrees, to a relative 1e-9, with the one that follows from other values of its
/// artifact. @throws InputError at the value: @p problem, the @p expected one, @p others to edit as well
void require_agreement(const View& value, double expected, Dimension dimension, const std::string& problem,
                       const std::string& others);

}  // namespace ashimpact
