// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "core/json/view.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// Calls @p read(law, node) for each member of a sample of an artifact that holds the results of a law, in
/// order.
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

}  // namespace ashimpact
