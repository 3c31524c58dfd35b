// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

/// Richardson extrapolation to step zero: fits value(h) = c0 + c1 h^p1 + c2 h^p2 + ... through all points and
/// returns c0, in the unit of the values. The error is the distance to the same without the largest step and
/// the highest power, so it belongs to the lower order and is on the safe side.
/// @param steps five or so step sizes in any unit, largest first
/// @param powers ascending, one fewer than there are steps
Estimate extrapolate(std::span<const double> steps, std::span<const double> values,
                     std::span<const double> powers);

/// Returns the coefficients c0, c1, ... of c0 + c1 h^p1 + ... through all points.
std::vector<double> fit_powers(std::span<const double> steps, std::span<const double> values,
                               std::span<const double> powers);

}  // namespace ashimpact::oracles
