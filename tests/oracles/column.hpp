// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

/// One column of the comparison: anything that can compute impacts. The functions take many impacts at a time
/// because a DEM code is started once for all of them.
struct Column {
    std::string name;
    std::function<bool(const ImpactCase&)> covers;
    std::function<std::vector<ImpactResult>(std::span<const ImpactCase>)> impacts;
    std::function<std::vector<bool>(std::span<const ImpactCase>)> rebounds;
};

/// Integration in time with GSL: every law and detachment.
Column time_domain_oracle();

/// Debian's LAMMPS: Hertz, DMT, and JKR ending load-controlled.
Column lammps_oracle();

/// Debian's LIGGGHTS: Hertz and DMT.
Column liggghts_oracle();

/// What is put to the test: solve_impact(), which claims a relative 1e-10.
Column solver_under_test();

/// Returns the critical velocity [m/s] by the solver under test.
/// @throws std::bad_optional_access where it finds none
double solver_critical_velocity(const ImpactCase& impact);

/// All columns; deviations are given from the first. A further column is one more function here.
std::vector<Column> columns();

/// Returns whether the impact rebounds at that velocity [m/s].
bool rebounds(const Column& column, const ImpactCase& impact, double velocity);

}  // namespace ashimpact::oracles
