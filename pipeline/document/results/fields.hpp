// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"
#include "pipeline/case/law_map.hpp"
#include "pipeline/run/results/velocity.hpp"

/// Members that several results have in common; those that may be missing or null.
namespace ashimpact {

[[nodiscard]] inline std::optional<double> number_if(const View& node, std::string_view key,
                                                     Dimension dimension) {
    const auto member = node.find(key);
    return member ? std::optional(member->number(dimension)) : std::nullopt;
}

[[nodiscard]] inline std::optional<Quantity> quantity_if(const View& node, std::string_view key,
                                                         Dimension dimension) {
    const auto member = node.find(key);
    return member ? std::optional(member->quantity(dimension)) : std::nullopt;
}

[[nodiscard]] inline std::string text_if(const View& node, std::string_view key) {
    const auto member = node.find(key);
    return member ? member->text() : std::string();
}

[[nodiscard]] inline std::vector<double> column_if(const View& node, std::string_view key,
                                                   Dimension dimension) {
    const auto member = node.find(key);
    return member ? member->column(dimension) : std::vector<double>();
}

[[nodiscard]] inline std::size_t count_if_any(const View& node, std::string_view key) {
    const auto member = node.find(key);
    return member ? static_cast<std::size_t>(std::max(0, member->integer())) : 0;
}

/// What @p read returns for a member; none if it is missing or null.
template <class Read>
[[nodiscard]] auto read_if(const View& node, std::string_view key, Read&& read)
    -> std::optional<std::decay_t<decltype(read(node))>> {
    const auto member = node.find(key);
    if (!member) return std::nullopt;
    return read(*member);
}

/// A list of what @p read returns for each element; empty if the member is missing or null.
template <class Read>
[[nodiscard]] auto list_if(const View& node, std::string_view key, Read&& read) {
    std::vector<std::decay_t<decltype(read(node))>> list;
    if (const auto member = node.find(key))
        for (const View& element : member->elements()) list.push_back(read(element));
    return list;
}

/// The samples of a result.
template <class Read>
[[nodiscard]] auto samples_of(const View& result, Read&& read) {
    return list_if(result, "samples", read);
}

/// Calls @p read(law, node) for each member of a sample that holds the results of a law, in order.
/// @param other_keys members that are no results of a law
/// @throws InputError with the JSON pointer for any other member whose key is not the name of a law
template <class Read>
void for_each_law(const View& sample, std::initializer_list<std::string_view> other_keys, Read&& read) {
    for (const auto& [name, node] : sample.members()) {
        if (std::find(other_keys.begin(), other_keys.end(), name) != other_keys.end()) continue;
        const Law law = at_place(node.pointer(), [&key = name] { return Law::named(key); });
        read(law, node);
    }
}

/// The members of an object under the names of laws.
template <class Read>
[[nodiscard]] auto by_law_if(const View& node, std::string_view key, Read&& read) {
    LawMap<std::decay_t<decltype(read(node))>> values;
    if (const auto member = node.find(key))
        for_each_law(*member, {}, [&](Law law, const View& value) { values.set(law, read(value)); });
    return values;
}

/// {"samples": [..]}, each as @p write writes it.
template <class Sample, class Write>
[[nodiscard]] Json samples_json(const std::vector<Sample>& samples, Write&& write) {
    Json list = Json::array();
    for (const Sample& sample : samples) list.push_back(write(sample));
    return {{"samples", std::move(list)}};
}

/// {"level", "lower", "upper"}; an end that the data do not bound is null.
[[nodiscard]] Json bounds_json(const Bounds& bounds, Dimension dimension);
/// The same, or null.
[[nodiscard]] Json bounds_json(const std::optional<Bounds>& bounds, Dimension dimension);
[[nodiscard]] Bounds read_bounds(const View& node, Dimension dimension);

/// {"value", "unit", "standard_uncertainty"} of a velocity, without its interval.
[[nodiscard]] Json velocity_json(const VelocityEstimate& velocity);
/// The same with "interval", and with "method" if it is stated.
[[nodiscard]] Json headline_json(const VelocityEstimate& velocity);
/// A velocity, which must be positive and in m/s, because its interval is.
[[nodiscard]] VelocityEstimate read_velocity(const View& node);

}  // namespace ashimpact
