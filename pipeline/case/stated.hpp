// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/quantities/names.hpp"
#include "core/quantities/quantity.hpp"

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

}  // namespace ashimpact
