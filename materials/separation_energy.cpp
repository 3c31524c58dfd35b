// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/separation_energy.hpp"

#include <cmath>
#include <numbers>

#include "core/quantities/checks.hpp"
#include "materials/contact_properties.hpp"

namespace ashimpact {

namespace {

/// (w^5 R^4/E*^2)^(1/3) [J]
double energy_scale(const AdhesiveContact& contact) {
    require_not_negative("work_of_adhesion", contact.work_of_adhesion, Dimension::energy_per_area);
    require_positive("effective_radius", contact.effective_radius, Dimension::length);
    require_positive("contact_modulus", contact.contact_modulus, Dimension::pressure);
    const double w = contact.work_of_adhesion;
    const double r = contact.effective_radius;
    return w * r * std::cbrt(w / contact.contact_modulus * w / contact.contact_modulus * r);
}

}  // namespace

double separation_energy_constant(Separation separation) {
    const double first_touch = 6 * std::cbrt(4.0);
    const double end = separation == Separation::pull_off ? 1 : -3 * std::cbrt(3.0);
    return std::cbrt(std::pow(std::numbers::pi, 5)) * (first_touch + end) / 10;
}

double separation_velocity_constant(Separation separation) {
    return std::sqrt(1.5 / std::numbers::pi * separation_energy_constant(separation));
}

double separation_energy(const AdhesiveContact& contact, Separation separation) {
    return separation_energy_constant(separation) * energy_scale(contact);
}

double separation_velocity(const AdhesiveContact& contact, double density, Separation separation) {
    return std::sqrt(2 * separation_energy(contact, separation) /
                     sphere_mass(contact.effective_radius, density));
}

namespace dong2013 {

double separation_energy(const AdhesiveContact& contact) {
    return energy_constant * energy_scale(contact);
}

double separation_velocity_from_mass(const AdhesiveContact& contact, double mass) {
    require_positive("mass", mass, Dimension::mass);
    return std::sqrt(velocity_squared_constant / mass * energy_scale(contact));
}

double separation_velocity(const AdhesiveContact& contact, double density) {
    require_positive("density", density, Dimension::density);
    const double r = contact.effective_radius;
    return velocity_constant * std::sqrt(energy_scale(contact) / (density * r * r * r));
}

}  // namespace dong2013

double tabor_parameter(const AdhesiveContact& contact, double equilibrium_distance) {
    require_positive("equilibrium_distance", equilibrium_distance, Dimension::length);
    static_cast<void>(energy_scale(contact));
    const double strain = contact.work_of_adhesion / (contact.contact_modulus * equilibrium_distance);
    return std::cbrt(contact.effective_radius / equilibrium_distance * strain * strain);
}

}  // namespace ashimpact
