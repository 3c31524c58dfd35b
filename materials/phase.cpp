// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/phase.hpp"

#include <cmath>

namespace ashimpact {

std::optional<double> PhaseProperty::uncertainty() const {
    if (standard_uncertainty) return standard_uncertainty;
    if (range) return (range->second - range->first) / std::sqrt(12.0);
    return std::nullopt;
}

}  // namespace ashimpact
