// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/law_map.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

/// Damping against restitution and velocity, by one law.
struct DampingSeries {
    std::string origin{};                ///< of the restitution data
    std::vector<double> velocity{};      ///< [m/s]
    std::vector<double> restitution{};   ///< above 0 [1]
    std::vector<double> damping{};       ///< [unit of the damping law]
    std::vector<double> contact_time{};  ///< [s]
    std::optional<double>
        rising_to{};  ///< velocity at the end of the rising branch; none: there is none [m/s]
};

/// The entry of a sample in 5-damping.json, as later stages read it.
struct SampleDamping {
    std::string name;
    LawMap<DampingSeries> laws;
};

/// The damping that gives back each restitution, with its uncertainty and the reachable range, the parts of
/// eta(v_in) and the rising branch; Dong et al. 2013, section 4.2. Captures (restitution 0) bound the damping
/// but do not fix it: they are listed apart.
[[nodiscard]] StageOutput damping_stage(const Artifacts& before);

/// @param dimension of the coefficient of the damping law
[[nodiscard]] std::vector<SampleDamping> read_dampings(const View& result, Dimension dimension);

}  // namespace ashimpact
