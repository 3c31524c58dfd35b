// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "bench/population.hpp"

namespace ashimpact::bench {

/// What a DEM code does with 10,000 impacts on a wall, DMT with constant damping, 200 steps a Hertz contact.
struct DemRate {
    std::string name;
    double rate;  ///< impacts a second of CPU time; that of starting and setting up is taken off
    Errors errors;
};

/// LAMMPS and LIGGGHTS. @throws std::runtime_error where one is missing or fails
[[nodiscard]] std::vector<DemRate> dem_rates(int repetitions);

}  // namespace ashimpact::bench
