// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/finding.hpp"
#include "core/quantities/names.hpp"

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

/// Returns the effective radius R* of two spheres [m]: 1/R* = 1/r1 + 1/r2. Source: Dong et al. 2013, Eq. 6.
/// A flat wall is an infinite r2, which gives R* = r1.
[[nodiscard]] double effective_radius(double particle_radius, double wall_radius);

/// Returns the effective mass m* [kg]: 1/m* = 1/m1 + 1/m2 (misprinted as m* = 1/m1 + 1/m2 after Eq. 2 of Dong
/// et al. 2013). A fixed wall is an infinite m2, which gives m* = m1.
[[nodiscard]] double effective_mass(double particle_mass, double wall_mass);

/// Returns the mass of a homogeneous sphere [kg]: (4/3) pi rho r^3.
[[nodiscard]] double sphere_mass(double radius, double density);

/// Returns the apparent density of a sphere [kg/m3] from its mass, the inverse of sphere_mass.
[[nodiscard]] double sphere_density(double radius, double mass);

/// The doubt about the density of a sphere that follows from its radius [m] and mass [kg]. None if the mass
/// itself is implausible: that is a doubt of its own.
[[nodiscard]] std::optional<Finding> implausible_mass(double radius, double mass);

/// How the work of adhesion w follows from the surface energies g1, g2 of the two bodies.
enum class AdhesionRule {
    girifalco_good,  ///< w = 2 sqrt(g1 g2)
    dong2013,        ///< w = sqrt(g1 g2), half of Girifalco-Good's, as the paper prints it
    dupre,           ///< w = g1 + g2 - g12, needs the interfacial energy
};

template <>
struct Names<AdhesionRule> {
    static constexpr std::string_view kind = "adhesion rule";
    static constexpr std::array<std::string_view, 3> all{"girifalco-good", "dong2013", "dupre"};
};

/// Surface energies [J/m2]; an energy per surface, not the work of adhesion.
struct SurfaceEnergies {
    double particle = 0;
    double wall = 0;
    std::optional<double> interfacial{};  ///< g12, for the Dupre rule only
};

/// Returns the work of adhesion w [J/m2], the reversible work per unit area to separate the two surfaces.
/// Sources: Girifalco & Good 1957 (J. Phys. Chem. 61:904, interaction parameter 1); Dupre 1869 as in
/// Israelachvili 2011, section 17.1; Dong et al. 2013, text under Eq. 11. There w = g1 + g2 + g12 is a
/// misprint, and w = sqrt(g1 g2) is half of what Dupre's rule gives with g12 = g1 + g2 - 2 sqrt(g1 g2).
/// Errors: InputError for negative energies, for g12 missing (dupre) or given (others), for w below zero.
[[nodiscard]] double work_of_adhesion(AdhesionRule rule, const SurfaceEnergies& energies);

/// Roughness of the surfaces in contact; see roughness_reduction().
struct Roughness {
    double rms = 0;                    ///< root-mean-square height of both surfaces together [m]
    double closest_distance = 0.3e-9;  ///< H_0, distance of surfaces in contact [m]
};

/// Returns the factor by which roughness reduces the work of adhesion [1], by the modified Rumpf model of
/// Rabinovich et al. 2000 (J. Colloid Interface Sci. 232:10, after Rumpf 1990):
///     w_rough/w = 1/(1 + R*/(1.48 rms)) + 1/(1 + 1.48 rms/H_0)^2.
/// A hemispherical asperity of radius 1.48 rms separates sphere and wall. The first term is the van der Waals
/// force of the asperity on the sphere, the second that of the wall at the distance H_0 + 1.48 rms. The model
/// gives the ratio of pull-off forces. Here it scales w, to which pull-off forces are proportional. Validity:
/// rms below about 20 nm and far below R*, one asperity under the contact, elastic deformation small against
/// the asperity (hard particles). 1 for rms = 0. A lower estimate: for wide asperities Rabinovich et al.
/// measured up to ten times more.
/// Errors: InputError for a negative rms or a radius or H_0 that is not positive.
[[nodiscard]] double roughness_reduction(double effective_radius, const Roughness& roughness);

/// The finding that roughness_reduction() is not meant for this @p rms: above 20 nm, or above a tenth of R*
/// [m].
[[nodiscard]] std::optional<Finding> roughness_doubt(double effective_radius, double rms);

/// Where a JKR contact breaks; K = (4/3) E*.
enum class Separation {
    pull_off,         ///< displacement control, at the fold a^3 = (1/6) pi w R^2/K; the paper's choice
    load_controlled,  ///< at the greatest tension, a^3 = (3/2) pi w R^2/K
};

/// A JKR contact of a sphere with a flat wall.
struct AdhesiveContact {
    double work_of_adhesion = 0;  ///< w [J/m2]
    double effective_radius = 0;  ///< R [m]
    double contact_modulus = 0;   ///< E* [Pa]
};

/// Returns c_W of W_s = c_W (w^5 R^4/E*^2)^(1/3) [1], exact.
/// In the normalisation of Dong et al. 2013, Eqs. 21, 25, 27, the integral of F d(delta) is
/// Phi = abar^2 (2x/5 - (2/3) sqrt(6x) + 1), x = abar^3. First touch (delta = 0) is x = 8/3; the ends are
/// x = 1/6 (pull-off) and x = 3/2 (load-controlled). So
///   pull-off:        c_W = pi^(5/3) (6 2^(2/3) + 1)/10       = 7.092195...
///   load-controlled: c_W = pi^(5/3) (6 2^(2/3) - 3^(4/3))/10 = 3.502601...
/// Derivation: docs/materials.md.
[[nodiscard]] double separation_energy_constant(Separation separation);

/// Returns c_v = sqrt(3 c_W/(2 pi)) of v_s = c_v (w/R)^(5/6)/(rho^3 E*^2)^(1/6) [1]; pull-off 1.840183...
[[nodiscard]] double separation_velocity_constant(Separation separation);

/// Returns W_s, the work to take a JKR contact from zero overlap to its break [J].
/// W_s = c_W (w^5 R^4/E*^2)^(1/3). Source: Dong et al. 2013, Eq. 28 (Thornton & Ning 1998), read with E* and
/// w where the paper prints Young's modulus and surface energy. Errors: InputError unless w >= 0, R, E* > 0.
[[nodiscard]] double separation_energy(const AdhesiveContact& contact,
                                       Separation separation = Separation::pull_off);

/// Returns the analytic critical velocity of an undamped JKR impact, v_s = sqrt(2 W_s/m) [m/s], of a sphere
/// of that density on a flat wall (effective radius = radius of the sphere). Source: Eqs. 29 and 30.
[[nodiscard]] double separation_velocity(const AdhesiveContact& contact, double density,
                                         Separation separation = Separation::pull_off);

/// The same with the constants as the paper rounds them, for comparison with its numbers.
namespace dong2013 {
inline constexpr double energy_constant = 7.09;             ///< Eq. 28
inline constexpr double velocity_squared_constant = 14.18;  ///< Eq. 29
inline constexpr double velocity_constant = 1.84;           ///< Eq. 30

/// Returns W_s by Eq. 28 [J].
[[nodiscard]] double separation_energy(const AdhesiveContact& contact);

/// Returns v_s by Eq. 29 [m/s], for any effective mass [kg].
[[nodiscard]] double separation_velocity_from_mass(const AdhesiveContact& contact, double mass);

/// Returns v_s by Eq. 30 [m/s]. The rounding of the constants makes it larger than by Eq. 29, by 6e-5 of v_s.
[[nodiscard]] double separation_velocity(const AdhesiveContact& contact, double density);

}  // namespace dong2013

/// Returns Tabor's parameter [1], (R w^2/(E*^2 z0^3))^(1/3) with the equilibrium distance z0 of the surfaces
/// [m]. JKR holds well above 5, DMT below 0.1 (Tabor 1977, J. Colloid Interface Sci. 58:2; Johnson &
/// Greenwood 1997, J. Colloid Interface Sci. 192:326).
[[nodiscard]] double tabor_parameter(const AdhesiveContact& contact, double equilibrium_distance);

}  // namespace ashimpact
