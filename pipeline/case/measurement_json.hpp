// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// Reads impacts in columns: velocity, restitution or rebound_velocity and, where they are known,
/// velocity_uncertainty, rebound_uncertainty (standard, of v_in and v_r), velocity_correlation (of these two
/// errors) and impacts (of which a point is the mean). Restitution 0 is a capture. restitution_uncertainty
/// may stand in place of rebound_uncertainty; the errors of v_in and e_n are then taken as independent.
/// @throws InputError with the JSON pointer for columns that contradict each other or invalid impacts
[[nodiscard]] MeasurementSet read_measurement_columns(const View& node);

/// Checks impacts before they are used. A restitution of 1 or more must be explained by three standard
/// uncertainties.
/// @throws InputError naming the point, or its line
void check_impacts(const MeasurementSet& set);

}  // namespace ashimpact
