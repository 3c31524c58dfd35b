// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "pipeline/run/results/run.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "solver/deposition/deposition.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// Particles whose rebounds are asked for.
struct ReboundingSizes {
    std::vector<double> diameters{};  ///< rising [m]
    std::vector<double> critical{};   ///< critical velocity of each [m/s]; 0: none; infinite: all is captured
    double fastest = 0;               ///< impact [m/s]
};

/// Restitution of each size by a contact law and its damping: solved impacts of some of the sizes, between
/// them and their velocities linear over ln d and sqrt(ln(v/v_c)), in which e is smooth.
/// @param impact_of a sphere of a diameter, at any velocity
[[nodiscard]] std::vector<RestitutionOfVelocity> restitutions_by_law(
    const ReboundingSizes& sizes, const std::function<Impact(double diameter)>& impact_of);

/// The impact of a sphere of a diameter at 1 m/s, by the reported law and the damping of an assumption, with
/// the constants that the run states; empty where it states none.
[[nodiscard]] std::function<Impact(double diameter)> assumed_impacts(const Run& run, SizeBasis basis);

/// The fastest impact that restitutions_of_run() rests on [m/s]; none if they follow from a damping.
[[nodiscard]] std::optional<double> fastest_impact(const Run& run);

/// Restitution of each size of a run: the means of neighbouring rebounds of the samples around it, of the
/// nearest one beyond them, at equal v/v_c. Of a run without impacts by the damping of an assumption; unknown
/// where it states none.
[[nodiscard]] std::vector<RestitutionOfVelocity> restitutions_of_run(const Run& run, SizeBasis basis,
                                                                     const ReboundingSizes& sizes);

}  // namespace ashimpact
