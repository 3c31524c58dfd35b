// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/names.hpp"
#include "core/quantities/quantity.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// Where a value comes from; see docs/case.md.
enum class Origin { given, measured, inferred, assumed, literature, published, computed, reconstructed };

template <>
struct Names<Origin> {
    static constexpr std::string_view kind = "origin";
    static constexpr std::array<std::string_view, 8> all{
        "given", "measured", "inferred", "assumed", "literature", "published", "computed", "reconstructed"};
};

/// A quantity of the case and where it comes from.
struct Stated {
    Quantity quantity{};  ///< in SI
    Origin origin = Origin::given;
    std::string source{};  ///< in words; may be empty

    [[nodiscard]] double value() const { return quantity.value; }
};

/// Values under contact laws, in the order of the registry, whatever the order in which they were given.
template <class Value>
class LawMap {
  public:
    void set(Law law, Value value) {
        const auto after = [&](const auto& entry) { return entry.first.index() > law.index(); };
        entries_.emplace(std::ranges::find_if(entries_, after), law, std::move(value));
    }
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
