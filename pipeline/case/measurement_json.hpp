// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/json/view.hpp"
#include "pipeline/case/listed_impacts.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The impacts of a series as columns: velocity, restitution (or rebound_velocity, which reads back exactly)
/// and, where there is something to say, velocity_uncertainty, rebound_uncertainty (standard, of v_in and
/// v_r), velocity_correlation (of these two errors) and impacts (of which a point is the mean). Restitution 0
/// is a capture.
[[nodiscard]] Json measurement_columns(const MeasurementSet& set, bool as_rebound_velocity = false);

/// The same of impacts that are in columns already, and back.
[[nodiscard]] Json to_json(const ListedImpacts& columns);
[[nodiscard]] ListedImpacts read_listed_impacts(const View& node);

/// Reads the columns of measurement_columns(). restitution_uncertainty may stand in place of
/// rebound_uncertainty; the errors of v_in and e_n are then taken as independent.
/// @throws InputError with the JSON pointer for columns that contradict each other or invalid impacts
[[nodiscard]] MeasurementSet read_measurement_columns(const View& node);

/// Checks impacts before they are used. A restitution of 1 or more must be explained by three standard
/// uncertainties.
/// @throws InputError naming the point, or its line
void check_impacts(const MeasurementSet& set);

}  // namespace ashimpact
