// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// The critical velocity of calibrated constants at a size.
struct CalibratedVelocity {
    double diameter = 0;               ///< [m]
    std::optional<double> velocity{};  ///< none: nothing rebounds [m/s]
    Interval interval{};               ///< 95 %, from the uncertainties and correlations of the constants
};

/// Critical velocities by the law of the observations over sizes, of constants that all sizes share. The
/// interval is linear in the logarithms.
[[nodiscard]] std::vector<CalibratedVelocity> velocities_over_sizes(const CalibrationProblem& problem,
                                                                    const CalibrationSummary& summary,
                                                                    const std::vector<double>& diameters);

}  // namespace ashimpact
