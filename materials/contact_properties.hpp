// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact {

/// Elastic constants of one isotropic body in contact.
struct ElasticBody {
    double young_modulus = 0;  ///< [Pa], positive
    double poisson_ratio = 0;  ///< [1], -1 < nu <= 0.5
};

/// A wall that does not deform.
struct RigidWall {};

/// Returns the contact modulus E* of two elastic bodies [Pa].
/// 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2. Source: Dong et al. 2013, Eq. 7 (Johnson 1985, section 4.2).
/// Errors: InputError for a modulus that is not positive or a Poisson ratio outside (-1, 0.5].
[[nodiscard]] double contact_modulus(const ElasticBody& particle, const ElasticBody& wall);

/// Returns the contact modulus E* on a rigid wall [Pa]: E1/(1 - nu1^2), Eq. 7 with E2 -> infinity.
[[nodiscard]] double contact_modulus(const ElasticBody& particle, RigidWall wall);

/// Returns d ln E* / d ln E1 [1], the share of the particle in the compliance: (E*/E1)(1 - nu1^2).
/// The relative standard uncertainty of E* from that of E1 is this times u(E1)/E1.
[[nodiscard]] double particle_share_of_compliance(const ElasticBody& particle, double contact_modulus);

/// Returns the effective radius R* of two spheres [m]: 1/R* = 1/r1 + 1/r2. Source: Dong et al. 2013, Eq. 6.
/// A flat wall is an infinite r2, which gives R* = r1.
[[nodiscard]] double effective_radius(double particle_radius, double wall_radius);

/// Returns the effective mass m* [kg]: 1/m* = 1/m1 + 1/m2. The paper prints m* = 1/m1 + 1/m2 after Eq. 2,
/// which is not a mass. A fixed wall is an infinite m2, which gives m* = m1.
[[nodiscard]] double effective_mass(double particle_mass, double wall_mass);

/// Returns the mass of a homogeneous sphere [kg]: (4/3) pi rho r^3.
[[nodiscard]] double sphere_mass(double radius, double density);

/// Returns the apparent density of a sphere [kg/m3] from its mass, the inverse of sphere_mass.
[[nodiscard]] double sphere_density(double radius, double mass);

}  // namespace ashimpact
