// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/inference/impacts/inverted_impacts.hpp"

namespace ashimpact {

/// Rebounds at similar angles of incidence.
struct AngleClass {
    double from, to;       ///< angles from the normal [rad]
    std::size_t rebounds;  ///< with a damping
    /// Mean of ln(eta over that of all rebounds at the same normal velocity), against the other classes [1].
    double difference;
    double standard_uncertainty;  ///< of it, from the scatter of the rebounds [1]
};

/// Whether the velocity normal to the wall alone decides the damping.
struct AngleComparison {
    std::vector<AngleClass> classes;  ///< from the normal on
    double probability;               ///< of differences as large if the normal velocity decides (F test) [1]

    [[nodiscard]] bool normal_decides() const { return probability >= 0.05; }
};

/// Compares classes of angle by the residuals of ln eta from its smooth curve over the normal velocity, by an
/// analysis of variance. Classes that lie at different velocities cannot be told apart from a change with the
/// velocity, which the curve follows.
/// @param set with tangential velocities; outliers are left out
/// @return none without a smooth curve, and where fewer than two classes of four rebounds and of angles three
/// degrees apart can be made
[[nodiscard]] std::optional<AngleComparison> compare_angles(const MeasurementSet& set,
                                                            const std::vector<InvertedImpact>& inverted,
                                                            const std::optional<DampingSmoothing>& smoothing);

}  // namespace ashimpact
