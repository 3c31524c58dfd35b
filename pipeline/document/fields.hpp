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
#include "pipeline/case/values.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/damping/damping.hpp"

/// One list of the fields of a struct gives its JSON object and reads it back:
///
///     void fields(auto& io, Is<ContactTimeAt> auto& time) {
///         io("law", time.law);
///         io("velocity", time.velocity, Dimension::velocity);
///         io("contact_time", time.contact_time, Dimension::time);
///     }
///
/// @p io is a FieldWriter or a FieldReader. The forms of single values are those of values_json.hpp; an
/// optional without a value is null, a list an array, values under names or laws an object, and a struct with
/// fields an object of these.
namespace ashimpact {

template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

namespace detail {

template <class T, template <class...> class Template>
inline constexpr bool is_a = false;
template <template <class...> class Template, class... Arguments>
inline constexpr bool is_a<Template<Arguments...>, Template> = true;

/// Values under names, in their order.
template <class T>
inline constexpr bool is_named_list = false;
template <class Value>
inline constexpr bool is_named_list<std::vector<std::pair<std::string, Value>>> = true;

}  // namespace detail

/// One column of a list of rows.
template <class Row>
struct FieldColumn {
    std::string_view key;
    double Row::*member;
    Dimension dimension;
    bool damping = false;  ///< the dimension is that of the damping law
};

/// Makes the JSON object of a struct.
class FieldWriter {
  public:
    static constexpr bool reads = false;
    explicit FieldWriter(DampingLaw law) : law_(law) {}

    /// A member that is always there.
    template <class T, class... Form>
    void operator()(std::string_view key, const T& value, Form... form) {
        json_[std::string(key)] = json_of(value, form...);
    }
    /// The same; artifacts without it are read too, and leave the value as it is.
    template <class T, class... Form>
    void lenient(std::string_view key, const T& value, Form... form) {
        (*this)(key, value, form...);
    }
    /// A member that is missing where there is no value, or an empty text or list.
    template <class T, class... Form>
    void unless_empty(std::string_view key, const T& value, Form... form) {
        if (!is_empty(value)) (*this)(key, value, form...);
    }
    /// A member that follows from others and is not read back.
    template <class T, class... Form>
    void derived(std::string_view key, const T& value, Form... form) {
        (*this)(key, value, form...);
    }
    /// A member that @p write makes of the value.
    template <class T, class Write, class Read>
    void by_hand(std::string_view key, const T& value, Write&& write, Read&& /*read*/) {
        json_[std::string(key)] = write(value);
    }
    void json(std::string_view key, Json value) { json_[std::string(key)] = std::move(value); }
    /// An object with further fields.
    template <class Fields>
    void object(std::string_view key, Fields&& list) {
        FieldWriter inner(law_);
        list(inner);
        json_[std::string(key)] = std::move(inner).json();
    }
    /// A member under the name of each law.
    template <class T>
    void under_laws(const LawMap<T>& values, std::initializer_list<std::string_view> /*other_keys*/) {
        for (const auto& [law, value] : values) (*this)(law.name(), value);
    }
    /// A result and, under its name with "_interval", the interval of it.
    void estimate(std::string_view key, const Interval& interval, Dimension dimension) {
        json_[std::string(key)] = estimate_json(interval, si_unit(dimension));
        json_[std::string(key) + "_interval"] = interval_json(interval, si_unit(dimension));
    }
    /// A column for each member of rows. Values that are not finite are null where @p gaps allows them.
    template <class Row>
    void columns(const std::vector<Row>& rows,
                 std::type_identity_t<std::span<const FieldColumn<Row>>> columns, bool gaps) {
        for (const auto& [key, member, dimension, damping] : columns) {
            Json values = Json::array();
            for (const Row& row : rows) values.push_back(gaps ? finite_json(row.*member) : Json(row.*member));
            json_[std::string(key)] = {{"values", std::move(values)},
                                       {"unit", damping ? unit_of(law_) : si_unit(dimension)}};
        }
    }

    [[nodiscard]] DampingLaw damping_law() const { return law_; }
    [[nodiscard]] Json json() && { return std::move(json_); }

  private:
    template <class T>
    static bool is_empty(const T& value) {
        if constexpr (detail::is_a<T, std::optional>)
            return !value;
        else
            return value.empty();
    }

    template <class T, class... Form>
    Json json_of(const T& value, Form... form) const {
        if constexpr (requires { value_json(value, form...); }) {
            return value_json(value, form...);
        } else if constexpr (detail::is_a<T, std::optional>) {
            return value ? json_of(*value, form...) : Json(nullptr);
        } else if constexpr (detail::is_named_list<T> || detail::is_a<T, LawMap>) {
            Json json = Json::object();
            for (const auto& [name, each] : value) json[std::string(text_of(name))] = json_of(each, form...);
            return json;
        } else if constexpr (detail::is_a<T, std::vector>) {
            Json json = Json::array();
            for (const auto& each : value) json.push_back(json_of(each, form...));
            return json;
        } else {
            FieldWriter inner(law_);
            fields(inner, value);
            return std::move(inner).json();
        }
    }

    static std::string_view text_of(const std::string& name) { return name; }
    static std::string_view text_of(Law law) { return law.name(); }

    Json json_ = Json::object();
    DampingLaw law_;
};

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

/// The JSON object of a struct with fields. @param law which determines the unit of damping coefficients
template <class Struct>
Json to_json(const Struct& value, DampingLaw law) {
    FieldWriter writer(law);
    fields(writer, value);
    return std::move(writer).json();
}

template <class Struct>
Struct from_json(const View& node, DampingLaw law) {
    Struct value{};
    FieldReader reader(node, law);
    fields(reader, value);
    return value;
}

template <class T>
requires detail::is_a<std::remove_const_t<T>, SampleResults>
void fields(auto& io, T& result) {
    io("samples", result.samples);
}

/// What is known of impacts beside their velocities.
void noise_fields(auto& io, Is<ListedImpacts> auto& columns) {
    io.unless_empty("velocity_uncertainty", columns.velocity_uncertainty, Dimension::velocity);
    io.unless_empty("rebound_uncertainty", columns.rebound_uncertainty, Dimension::velocity);
    io.unless_empty("velocity_correlation", columns.correlation, Dimension::fraction);
    io.unless_empty("impacts", columns.counts, Dimension::fraction);
}

void fields(auto& io, Is<ListedImpacts> auto& columns) {
    io("velocity", columns.velocity, Dimension::velocity);
    io("restitution", columns.restitution, Dimension::fraction);
    noise_fields(io, columns);
}

}  // namespace ashimpact
