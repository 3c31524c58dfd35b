// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact {

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

/// Returns the analytic critical velocity of an undamped JKR impact, v_s = sqrt(2 W_s/m) [m/s]. Eqs. 29, 30
/// for a sphere of that density on a flat wall (effective radius = radius of the sphere).
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

/// Returns v_s by Eq. 30 [m/s]; 6e-5 larger, relatively, than Eq. 29, which is rounded differently.
[[nodiscard]] double separation_velocity(const AdhesiveContact& contact, double density);

}  // namespace dong2013

/// Returns Tabor's parameter [1], (R w^2/(E*^2 z0^3))^(1/3) with the equilibrium distance z0 of the surfaces
/// [m]. JKR holds well above 5, DMT below 0.1 (Tabor 1977, J. Colloid Interface Sci. 58:2; Johnson &
/// Greenwood 1997, J. Colloid Interface Sci. 192:326).
[[nodiscard]] double tabor_parameter(const AdhesiveContact& contact, double equilibrium_distance);

}  // namespace ashimpact
