// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// Data of a fit of eta(e_n). Robust fits give rebounds weights below one.
struct RestitutionData {
    std::vector<Measurement> rebounds;  ///< each with its noise
    std::vector<double> weights;
    double greatest_restitution;  ///< upper end of the curve
};

}  // namespace ashimpact
