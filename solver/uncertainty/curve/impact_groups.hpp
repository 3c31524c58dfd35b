#pragma once

#include "solver/measurement/measurement.hpp"
#include "solver/uncertainty/curve/impact_probability.hpp"

#include <vector>

namespace ashimpact {

/// The impacts of a set as the likelihood needs them, one by one.
[[nodiscard]] std::vector<RecordedImpact> recorded_impacts(const MeasurementSet& set);

/// Groups impacts, so that a million cost no more than some thousand. At velocities with captures, impacts
/// within a cell half as wide as their noise become one that counts for all. Faster ones are averaged over a
/// six-hundredth of the range, in which the curve is straight; the mean has the noise of a mean.
/// @param impacts with known noise
[[nodiscard]] std::vector<RecordedImpact> grouped(std::vector<RecordedImpact> impacts);

/// Standard uncertainty of both velocities from the scatter of neighbours about straight lines, for sets that
/// state none [m/s].
[[nodiscard]] double noise_of_neighbours(const std::vector<RecordedImpact>& impacts);

/// Number of impacts up to which none are grouped.
inline constexpr std::size_t few_impacts = 2500;

}  // namespace ashimpact
