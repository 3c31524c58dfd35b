// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/checks.hpp"

namespace ashimpact {

/// Names of the values of an enumeration, as files, options and results write them. An enumeration gets names
/// by a specialisation beside its declaration:
///   static constexpr std::string_view kind = "mixture rule";  // for messages
///   static constexpr std::array<std::string_view, n> all{...};  // in the order of its values 0, 1, ...
template <class Enum>
struct Names;

template <class Enum>
concept Named = requires {
    Names<Enum>::all;
};

/// The name of a value.
template <Named Enum>
[[nodiscard]] constexpr std::string_view name_of(Enum value) {
    return Names<Enum>::all.at(static_cast<std::size_t>(value));
}

/// All values of an enumeration, in its order.
template <Named Enum>
inline constexpr auto all_values = []() constexpr {
    std::array<Enum, Names<Enum>::all.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
    return values;
}
();

/// All names of an enumeration, in its order.
template <Named Enum>
[[nodiscard]] std::vector<std::string> names_of() {
    return {Names<Enum>::all.begin(), Names<Enum>::all.end()};
}

/// The value of that name. @throws InputError with the nearest name and a list of all names
template <Named Enum>
[[nodiscard]] Enum named(std::string_view name) {
    for (std::size_t i = 0; i < Names<Enum>::all.size(); ++i)
        if (Names<Enum>::all[i] == name) return static_cast<Enum>(i);
    throw unknown_name(Names<Enum>::kind, name, names_of<Enum>());
}

}  // namespace ashimpact
