// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/law_map.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

/// Dynamic critical velocity by one law.
struct LawCriticalVelocity {
    std::string verdict;
    std::optional<Quantity> value;       ///< where finite [m/s]
    std::optional<double> contact_time;  ///< where finite [s]
    double dissipated;                   ///< work of damping at v_c [J]
    double plastic;                      ///< work spent in yielding at v_c [J]
    double detachment_energy;            ///< what the break itself costs [J]
    Json interval;                       ///< of 95 %, null if unknown
    Json interval_note;                  ///< why there is none, null where there is one
    Json check;                          ///< against the measured one, null if there is none
    Json headline = nullptr;             ///< the velocity with interval and method
    Json extrapolated = nullptr;         ///< the same by the paper's extrapolation, null where there is none
};

/// The entry of a sample in 7-critical-velocity.json, as later stages read it.
struct SampleCriticalVelocity {
    std::string name;
    LawMap<LawCriticalVelocity> laws;
    Json measured;  ///< the critical velocity that was measured; null: none was
};

/// The dynamic critical velocity at the critical damping (Dong et al. 2013, section 4.3, Table 4) with its
/// interval, what dominates it, the regime of the impact, and the measured one beside it.
[[nodiscard]] StageOutput critical_velocity_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleCriticalVelocity> read_critical_velocities(const View& result);

/// A critical velocity with the keys of `ashimpact critical-velocity --json`.
[[nodiscard]] Json critical_velocity_json(const CriticalVelocityProblem& problem,
                                          const CriticalVelocity& result);

}  // namespace ashimpact
