// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/units/unit_database.hpp"

namespace ashimpact {

/// A unit in the grammar of UDUNITS-2, of what the database names; none where it is not one.
[[nodiscard]] std::optional<UnitDatabase::Unit> read_unit(const UnitDatabase& units, std::string_view text);

}  // namespace ashimpact
