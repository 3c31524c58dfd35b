// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/work_of_adhesion.hpp"

#include <cmath>
#include <string>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"

namespace ashimpact {

namespace {

double interfacial_energy(const SurfaceEnergies& energies) {
    if (!energies.interfacial)
        throw InputError("the rule dupre has no interfacial energy", "an energy per area [J/m2]");
    require_not_negative("interfacial energy", *energies.interfacial, Dimension::energy_per_area);
    return *energies.interfacial;
}

}  // namespace

double work_of_adhesion(AdhesionRule rule, const SurfaceEnergies& energies) {
    require_not_negative("surface energy of the particle", energies.particle, Dimension::energy_per_area);
    require_not_negative("surface energy of the wall", energies.wall, Dimension::energy_per_area);
    if (rule == AdhesionRule::dupre) {
        const double w = energies.particle + energies.wall - interfacial_energy(energies);
        require_not_negative("work of adhesion by the rule dupre", w, Dimension::energy_per_area);
        return w;
    }
    if (energies.interfacial)
        throw InputError(
            "an interfacial energy is given, which the rule " + std::string(name_of(rule)) + " does not use",
            "the rule dupre, or no interfacial energy");
    const double geometric_mean = std::sqrt(energies.particle) * std::sqrt(energies.wall);
    return rule == AdhesionRule::girifalco_good ? 2 * geometric_mean : geometric_mean;
}

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
