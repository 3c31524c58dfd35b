// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/run/stage.hpp"

namespace ashimpact {

/// The entry of a sample in 3-analytic.json, as later stages read it.
struct SampleAnalytic {
    std::string name;
    double separation_energy;  ///< W_s [J]
    double critical_velocity;  ///< v_s of Eq. 30 [m/s]
};

/// Energy to separate a JKR contact and the velocity that just supplies it; Dong et al. 2013, Eqs. 28-30,
/// read with the contact modulus and the work of adhesion.
[[nodiscard]] StageOutput analytic_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleAnalytic> read_analytic(const View& result);

}  // namespace ashimpact
