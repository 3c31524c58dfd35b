#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/law_map.hpp"
#include "pipeline/stages/stage.hpp"
#include "solver/critical_velocity.hpp"

namespace ashimpact {

/// Dynamic critical velocity by one law.
struct LawCriticalVelocity {
    std::string verdict;
    std::optional<double> value;         ///< where finite [m/s]
    std::optional<double> contact_time;  ///< where finite [s]
    double dissipated;                   ///< work of damping at v_c [J]
    double plastic;                      ///< work spent in yielding at v_c [J]
    double detachment_energy;            ///< what the break itself costs [J]
};

/// What later stages need of 7-critical-velocity.json.
struct SampleCriticalVelocity {
    std::string name;
    LawMap<LawCriticalVelocity> laws;
};

/// The dynamic critical velocity at the critical damping; Dong et al. 2013, section 4.3, Table 4.
[[nodiscard]] StageOutput critical_velocity_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleCriticalVelocity> read_critical_velocities(const View& result);

/// A critical velocity with the keys of `ashimpact critical-velocity --json`.
[[nodiscard]] Json critical_velocity_json(const CriticalVelocityProblem& problem,
                                          const CriticalVelocity& result);

}  // namespace ashimpact
