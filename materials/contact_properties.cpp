// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/contact_properties.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"

namespace ashimpact {

namespace {

/// (1 - nu^2)/E [1/Pa]
double plane_strain_compliance(const ElasticBody& body) {
    require_positive("young_modulus", body.young_modulus, Dimension::pressure);
    require_poisson_ratio("poisson_ratio", body.poisson_ratio);
    return (1 - body.poisson_ratio * body.poisson_ratio) / body.young_modulus;
}

double required_interfacial_energy(const SurfaceEnergies& energies) {
    if (!energies.interfacial)
        throw InputError("the rule dupre has no interfacial energy", "an energy per area [J/m2]");
    require_not_negative("interfacial energy", *energies.interfacial, Dimension::energy_per_area);
    return *energies.interfacial;
}

void require_valid(const AdhesiveContact& contact) {
    require_not_negative("work_of_adhesion", contact.work_of_adhesion, Dimension::energy_per_area);
    require_positive("effective_radius", contact.effective_radius, Dimension::length);
    require_positive("contact_modulus", contact.contact_modulus, Dimension::pressure);
}

/// (w^5 R^4/E*^2)^(1/3) [J]
double energy_scale(const AdhesiveContact& contact) {
    require_valid(contact);
    const double w = contact.work_of_adhesion;
    const double r = contact.effective_radius;
    return w * r * std::cbrt(w / contact.contact_modulus * w / contact.contact_modulus * r);
}

}  // namespace

double contact_modulus(const ElasticBody& particle, const ElasticBody& wall) {
    return 1 / (plane_strain_compliance(particle) + plane_strain_compliance(wall));
}

double contact_modulus(const ElasticBody& particle, RigidWall /*wall*/) {
    return 1 / plane_strain_compliance(particle);
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

std::optional<Finding> implausible_mass(double radius, double mass) {
    if (!plausible_range("mass")->holds(mass)) return std::nullopt;
    return implausible_at("density of the sphere", *plausible_range("density"),
                          {sphere_density(radius, mass)});
}

double work_of_adhesion(AdhesionRule rule, const SurfaceEnergies& energies) {
    require_not_negative("surface energy of the particle", energies.particle, Dimension::energy_per_area);
    require_not_negative("surface energy of the wall", energies.wall, Dimension::energy_per_area);
    if (rule == AdhesionRule::dupre) {
        const double w = energies.particle + energies.wall - required_interfacial_energy(energies);
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
    const double asperity_radius = 1.48 * roughness.rms;
    const double wall_distance = 1 + asperity_radius / roughness.closest_distance;  // in units of H_0
    return 1 / (1 + effective_radius / asperity_radius) + 1 / (wall_distance * wall_distance);
}

std::optional<Finding> roughness_doubt(double effective_radius, double rms) {
    if (rms <= 20e-9 && rms <= 0.1 * effective_radius) return std::nullopt;
    return Finding{
        "roughness", Severity::remark,
        "the reduction of the work of adhesion by roughness is meant for an rms of 20 nm at most, far "
        "below the radius"};
}

double separation_energy_constant(Separation separation) {
    // -Phi at first touch and Phi at the break, in units of pi^(5/3)/10 (w^5 R^4/E*^2)^(1/3).
    const double minus_touch = 6 * std::cbrt(4.0);
    const double at_break = separation == Separation::pull_off ? 1 : -3 * std::cbrt(3.0);
    return std::cbrt(std::pow(std::numbers::pi, 5)) * (minus_touch + at_break) / 10;
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
    require_valid(contact);
    const double strain = contact.work_of_adhesion / (contact.contact_modulus * equilibrium_distance);
    return std::cbrt(contact.effective_radius / equilibrium_distance * strain * strain);
}

}  // namespace ashimpact
