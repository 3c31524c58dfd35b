// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/comparison.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/damping.hpp"

namespace ashimpact {

/// Incident velocities between which a series has values [m/s].
struct SeriesRange {
    double slowest;
    double fastest;
};

/// Round velocities that lie in at least two of the ranges, increasing, about five to twelve where the ranges
/// are wide enough [m/s].
[[nodiscard]] std::vector<double> shared_velocities(const std::vector<SeriesRange>& ranges);

/// Samples and laws compared at equal incident velocities (Figure 8 of Dong et al. 2013): for each velocity
/// the damping, and restitution, contact time and greatest overlap of the impact with it. Between the points
/// of a series the damping is interpolated without overshoot; that of measured impacts which can be smoothed
/// is their smooth curve. Nothing is extrapolated: a series is absent where it has no points.
[[nodiscard]] std::vector<EqualVelocity> equal_velocities(const Case& data, const ContactResult& contacts,
                                                          const DampingStageResult& dampings);

}  // namespace ashimpact
