// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/contact_properties.hpp"

#include <numbers>

#include "core/quantities/checks.hpp"

namespace ashimpact {

namespace {

/// (1 - nu^2)/E [1/Pa]
double plane_strain_compliance(const ElasticBody& body) {
    require_positive("young_modulus", body.young_modulus, Dimension::pressure);
    require_poisson_ratio("poisson_ratio", body.poisson_ratio);
    return (1 - body.poisson_ratio * body.poisson_ratio) / body.young_modulus;
}

}  // namespace

double contact_modulus(const ElasticBody& particle, const ElasticBody& wall) {
    return 1 / (plane_strain_compliance(particle) + plane_strain_compliance(wall));
}

double contact_modulus(const ElasticBody& particle, RigidWall /*wall*/) {
    return 1 / plane_strain_compliance(particle);
}

double particle_share_of_compliance(const ElasticBody& particle, double contact_modulus) {
    return contact_modulus * plane_strain_compliance(particle);
}

double effective_radius(double particle_radius, double wall_radius) {
    require_positive("particle_radius", particle_radius, Dimension::length);
    require_positive_or_infinite("wall_radius", wall_radius, Dimension::length);
    return 1 / (1 / particle_radius + 1 / wall_radius);
}

double effective_mass(double particle_mass, double wall_mass) {
    require_positive("particle_mass", particle_mass, Dimension::mass);
    require_positive_or_infinite("wall_mass", wall_mass, Dimension::mass);
    return 1 / (1 / particle_mass + 1 / wall_mass);
}

double sphere_mass(double radius, double density) {
    require_positive("radius", radius, Dimension::length);
    require_positive("density", density, Dimension::density);
    return 4.0 / 3.0 * std::numbers::pi * density * radius * radius * radius;
}

double sphere_density(double radius, double mass) {
    require_positive("radius", radius, Dimension::length);
    require_positive("mass", mass, Dimension::mass);
    return mass / (4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
}

}  // namespace ashimpact
