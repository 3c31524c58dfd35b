// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units/unit_system.hpp"

namespace ashimpact {

/// The database of UDUNITS-2 without its library: names, prefixes and the grammar of products, quotients and
/// powers. Origins and logarithms have no factor; a unit that is defined by one counts as of another
/// dimension.
class UnitDatabase {
  public:
    /// A factor times powers of the base units.
    struct Unit {
        double factor = 1;
        std::array<int, 7> powers{};
        bool proportional = true;  ///< to its base units, without origin or logarithm
    };

    /// @param folder with udunits2-base.xml and the files beside it
    explicit UnitDatabase(const std::string& folder);

    /// As ashimpact::scale_to(), for text in ASCII.
    [[nodiscard]] UnitScale scale(std::string_view unit, std::string_view target) const;
    /// Every name and symbol in ASCII, prefixes left out.
    [[nodiscard]] std::vector<std::string> names() const;
    /// The unit of a name or symbol, with or without prefixes; none if unknown.
    [[nodiscard]] std::optional<Unit> named(std::string_view name) const;

  private:
    void read(const std::string& file);
    [[nodiscard]] const std::string* definition(std::string_view name) const;

    std::map<std::string, std::string, std::less<>> names_;    ///< in lower case, with their definitions
    std::map<std::string, std::string, std::less<>> symbols_;  ///< case matters
    std::map<std::string, double, std::less<>> name_prefixes_;
    std::map<std::string, double, std::less<>> symbol_prefixes_;
    int bases_ = 0;
};

}  // namespace ashimpact
