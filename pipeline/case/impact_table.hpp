#pragma once

#include <string_view>

#include "pipeline/case/case.hpp"

namespace ashimpact {

/// Reads measured impacts from a table with a heading: `velocity [m/s]` and `restitution`, or
/// `rebound_velocity [m/s]` instead of it. Separators: comma, semicolon or tab; units in square or round
/// brackets, SI where there are none; other columns are left aside.
/// @throws InputError with the line number
[[nodiscard]] MeasuredRestitution read_impact_table(std::string_view text);

}  // namespace ashimpact
