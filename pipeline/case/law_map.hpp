// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "solver/contact/law.hpp"

namespace ashimpact {

/// Values under contact laws, in the order they were given.
template <class Value>
class LawMap {
  public:
    void set(Law law, Value value) { entries_.emplace_back(law, std::move(value)); }
    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] auto begin() const { return entries_.begin(); }
    [[nodiscard]] auto end() const { return entries_.end(); }

    /// The value of a law, or null.
    [[nodiscard]] const Value* find(Law law) const {
        for (const auto& [key, value] : entries_)
            if (key == law) return &value;
        return nullptr;
    }

  private:
    std::vector<std::pair<Law, Value>> entries_;
};

}  // namespace ashimpact
