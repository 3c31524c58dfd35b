// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/roughness.hpp"

#include "core/quantities/checks.hpp"

namespace ashimpact {

double roughness_reduction(double effective_radius, const Roughness& roughness) {
    require_positive("effective_radius", effective_radius, Dimension::length);
    require_not_negative("rms roughness", roughness.rms, Dimension::length);
    require_positive("closest distance of the surfaces", roughness.closest_distance, Dimension::length);
    if (roughness.rms == 0) return 1;
    const double asperity = 1.48 * roughness.rms;
    const double held_off = 1 + asperity / roughness.closest_distance;
    return 1 / (1 + effective_radius / asperity) + 1 / (held_off * held_off);
}

}  // namespace ashimpact
