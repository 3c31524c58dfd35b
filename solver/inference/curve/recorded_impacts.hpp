// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The recorded outcome of an impact.
enum class Recorded {
    rebound,  ///< with a velocity above zero
    zero,     ///< no rebound was seen: a capture, or a rebound too slow for the camera
    capture,  ///< seen to stick
};

/// One impact as the likelihood needs it.
struct RecordedImpact {
    Recorded recorded;
    double velocity;           ///< v_in [m/s]
    double log_velocity;       ///< ln v_in
    double rebound;            ///< v_r as read; 0 where there is no reading [m/s]
    double incident_u;         ///< standard uncertainty of v_in, in units of the noise scale
    double rebound_u;          ///< of v_r
    double correlation = 0.0;  ///< of the errors of both
    double resolution;         ///< v_r from which on the camera always sees it move; 0: not known [m/s]
    double count = 1.0;        ///< impacts merged into this one
};

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
/// @param share of the rebounds that count, the slowest ones but at least twelve: noise often grows with
/// velocity
[[nodiscard]] double noise_of_neighbours(const std::vector<RecordedImpact>& impacts, double share = 1.0);

/// Greatest number of impacts that are not grouped.
inline constexpr std::size_t few_impacts = 2500;

}  // namespace ashimpact
