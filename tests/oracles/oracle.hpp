#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

/// One column of the comparison: anything that can compute impacts. The functions take many impacts at a time
/// because a DEM code is started once for all of them.
struct Oracle {
    std::string name;
    std::function<bool(const ImpactCase&)> covers;
    std::function<std::vector<ImpactResult>(std::span<const ImpactCase>)> impacts;
    std::function<std::vector<bool>(std::span<const ImpactCase>)> rebounds;
};

/// Integration in time with GSL: every law and detachment.
Oracle time_domain_oracle();

/// Debian's LAMMPS: Hertz, DMT, and JKR ending load-controlled.
Oracle lammps_oracle();

/// Debian's LIGGGHTS: Hertz and DMT.
Oracle liggghts_oracle();

/// All columns; deviations are given from the first. A further column is one more function here.
std::vector<Oracle> oracles();

/// Returns whether the impact rebounds at that velocity [m/s].
bool rebounds(const Oracle& oracle, const ImpactCase& impact, double velocity);

}  // namespace ashimpact::oracles
