// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/case/values.hpp"
#include "pipeline/document/values_json.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

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

}  // namespace ashimpact
