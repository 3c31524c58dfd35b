// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/inference/curve/impact_probability.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The impacts of a set in the form that the likelihood takes.
[[nodiscard]] std::vector<RecordedImpact> recorded_impacts(const MeasurementSet& set);

/// Impacts merged into groups, so that a million take no longer than some thousand. At velocities at which
/// captures occur, impacts within a cell half as wide as their noise become one with their number as its
/// weight. Faster ones are averaged over a six-hundredth of the range, in which the curve is straight; the
/// average has the noise of a mean.
/// @param impacts with known noise
[[nodiscard]] std::vector<RecordedImpact> grouped(std::vector<RecordedImpact> impacts);

/// Standard uncertainty of both velocities, estimated from the scatter of neighbouring rebounds about
/// straight lines, for sets that state none [m/s].
[[nodiscard]] double noise_of_neighbours(const std::vector<RecordedImpact>& impacts);

/// Greatest number of impacts that are not grouped.
inline constexpr std::size_t few_impacts = 2500;

}  // namespace ashimpact
