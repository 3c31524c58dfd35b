// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "materials/composition.hpp"

namespace ashimpact::xrd {

/// Divides fractions and their uncertainties by the total of the fractions, so that they add up to one.
inline void normalise(std::vector<PhaseFraction>& phases, double total) {
    for (PhaseFraction& phase : phases) {
        phase.fraction /= total;
        if (phase.standard_uncertainty) *phase.standard_uncertainty /= total;
    }
}

}  // namespace ashimpact::xrd
