// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// Impacts in the columns in which artifacts list them. Restitution 0 is a capture.
struct ListedImpacts {
    std::vector<double> velocity{};              ///< v_in [m/s]
    std::vector<double> restitution{};           ///< [1]
    std::vector<double> velocity_uncertainty{};  ///< standard; empty: the noise is not known [m/s]
    std::vector<double> rebound_uncertainty{};   ///< standard, of v_r; empty as well [m/s]
    std::vector<double> correlation{};           ///< of these two errors; empty: none [1]
    std::vector<double> counts{};                ///< impacts of which a point is the mean; empty: one each
};

[[nodiscard]] ListedImpacts columns_of(const MeasurementSet& set);

/// The impacts of these columns; they differ from those of columns_of() by rounding.
/// @param columns of one length
[[nodiscard]] MeasurementSet impacts_of(const ListedImpacts& columns);

}  // namespace ashimpact
