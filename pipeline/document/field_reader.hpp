// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/json/view.hpp"
#include "pipeline/document/field_writer.hpp"

namespace ashimpact {

/// Sets a struct from its JSON object. Errors: InputError with the JSON pointer.
class FieldReader {
  public:
    static constexpr bool reads = true;
    FieldReader(View node, DampingLaw law) : node_(std::move(node)), law_(law) {}

    template <class T, class... Form>
    void operator()(std::string_view key, T& value, Form... form) const {
        constexpr bool or_null = (std::same_as<Form, NullIfNotFinite> || ...);
        if constexpr (std::same_as<T, double> && or_null) value = std::numeric_limits<double>::quiet_NaN();
        if constexpr (detail::is_a<T, std::optional> || or_null)
            lenient(key, value, form...);
        else
            read(node_.at(key), value, form...);
    }
    template <class T, class... Form>
    void lenient(std::string_view key, T& value, Form... form) const {
        if (const auto member = node_.find(key)) read(*member, value, form...);
    }
    template <class T, class... Form>
    void unless_empty(std::string_view key, T& value, Form... form) const {
        lenient(key, value, form...);
    }
    template <class T, class... Form>
    void derived(std::string_view /*key*/, const T& /*value*/, Form... /*form*/) const {}
    template <class T, class Write, class Read>
    void by_hand(std::string_view key, T& value, Write&& /*write*/, Read&& read) const {
        if (const auto member = node_.find(key)) value = read(*member);
    }
    template <class Fields>
    void object(std::string_view key, Fields&& list) const {
        FieldReader inner(node_.at(key), law_);
        list(inner);
    }
    /// @param other_keys members that are not under the name of a law
    template <class T>
    void under_laws(LawMap<T>& values, std::initializer_list<std::string_view> other_keys) const {
        for (const auto& [name, member] : node_.members())
            if (std::ranges::find(other_keys, name) == other_keys.end()) read_under_law(name, member, values);
    }
    void estimate(std::string_view key, Interval& interval, Dimension dimension) const {
        interval = read_estimate(node_, std::string(key), dimension);
    }
    template <class Row>
    void columns(std::vector<Row>& rows, std::type_identity_t<std::span<const FieldColumn<Row>>> columns,
                 bool gaps) const {
        const std::string_view first = columns.front().key;
        const auto values_in = [&](std::string_view key) {
            return gaps ? node_.at(key).at("values") : node_.at(key);
        };
        for (const auto& [key, member, plain, damping] : columns) {
            const Dimension dimension = damping ? dimension_of(law_) : plain;
            const View node = values_in(key);
            const auto values = gaps ? read_column_with_gaps(node, dimension) : node.column(dimension);
            if (key == first) rows.resize(values.size());
            if (values.size() != rows.size())
                node.fail("is not as long as the " + std::string(first), "columns of one length");
            for (std::size_t i = 0; i < values.size(); ++i) rows[i].*member = values[i];
        }
    }

    [[nodiscard]] const View& node() const { return node_; }
    [[nodiscard]] DampingLaw damping_law() const { return law_; }

  private:
    template <class T, class... Form>
    void read(const View& node, T& value, Form... form) const {
        if constexpr (requires { read_value(node, value, form...); }) {
            read_value(node, value, form...);
        } else if constexpr (detail::is_a<T, std::optional>) {
            if (!node.json().is_null()) read(node, value.emplace(), form...);
        } else if constexpr (detail::is_a<T, LawMap>) {
            for (const auto& [name, member] : node.members()) read_under_law(name, member, value, form...);
        } else if constexpr (detail::is_named_list<T>) {
            for (const auto& [name, member] : node.members())
                read(member, value.emplace_back(name, typename T::value_type::second_type{}).second, form...);
        } else if constexpr (detail::is_a<T, std::vector>) {
            for (const View& element : node.elements()) read(element, value.emplace_back(), form...);
        } else {
            FieldReader inner(node, law_);
            fields(inner, value);
        }
    }

    template <class T, class... Form>
    void read_under_law(const std::string& name, const View& member, LawMap<T>& values, Form... form) const {
        const Law law = at_place(member.pointer(), [&] { return Law::named(name); });
        T value{};
        read(member, value, form...);
        values.set(law, std::move(value));
    }

    View node_;
    DampingLaw law_;
};

}  // namespace ashimpact
