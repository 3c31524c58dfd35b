// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

/// Units of Maugis, in which the transition parameter is the only number of a pair; w must be above 0.
struct MaugisUnits {
    double radius;   ///< (pi w R^2/K)^(1/3), K = (4/3) E* [m]
    double overlap;  ///< (pi^2 w^2 R/K^2)^(1/3) [m]
    double force;    ///< pi w R [N]

    [[nodiscard]] double energy() const { return force * overlap; }  ///< [J]
};
[[nodiscard]] MaugisUnits maugis_units(const ContactPair& contact);

/// Returns the cohesive stress of a surface whose range is z0 [Pa]: 16 w/(9 sqrt 3 z0) = 1.0264 w/z0, the
/// strength of a Lennard-Jones surface of equilibrium separation z0. The Dugdale zone has that strength and,
/// with h_0 = w/sigma_0, the same work of adhesion.
[[nodiscard]] double cohesive_stress_of_range(double work_of_adhesion, double range);

/// Returns Maugis' transition parameter [1], 2 sigma_0 (R/(pi w K^2))^(1/3) with K = (4/3) E*. Maugis 1992,
/// J. Colloid Interface Sci. 150:243. Requires w > 0.
[[nodiscard]] double transition_parameter(const ContactPair& contact, double stress);

/// Returns the transition parameter of a pair that carries one parameter of law maugis-dugdale [1].
/// Requires w > 0. @throws InputError outside 1e-4 to 1e6, the range that the law computes
[[nodiscard]] double transition_parameter(const ContactPair& contact);
/// As above, whatever its value.
[[nodiscard]] double stated_transition_parameter(const ContactPair& contact);
inline constexpr double least_transition = 1e-4;
/// Whether law maugis-dugdale computes a transition parameter.
[[nodiscard]] constexpr bool is_computed_transition(double lambda) {
    return lambda >= least_transition && lambda <= 1e6;
}

/// lambda/mu for the Tabor parameter mu = (R w^2/(E*^2 z0^3))^(1/3): (32/(9 sqrt 3)) (9/(16 pi))^(1/3)
/// = 1.1570.
[[nodiscard]] double transition_per_tabor();

/// Returns the work lost in both jumps of an impact without damping, W_s(lambda) [J]: 0 for DMT (lambda to
/// 0), 7.0922 (w^5 R^4/E*^2)^(1/3) for JKR (lambda to infinity), where it is Eq. 28 of Dong et al. 2013.
[[nodiscard]] double cohesive_separation_energy(const ContactPair& contact, double lambda);

/// Returns v_s(lambda) = sqrt(2 W_s(lambda)/m) [m/s], which is Eq. 30 for lambda to infinity.
[[nodiscard]] double cohesive_separation_velocity(const ContactPair& contact, double lambda);

/// Returns W_s(lambda)/W_s(JKR) by a closed form of this project, for use by hand [1]. It is exact below
/// lambda = 0.655, where both jumps happen in the gap and W_s goes with lambda^5. Above it is a minimax fit,
/// within 0.6 %.
[[nodiscard]] double fitted_energy_ratio(double lambda);

/// The greatest relative error of fitted_energy_ratio() [1]; a test holds it over lambda 0.01 to 1e4.
inline constexpr double fitted_energy_error = 0.006;

/// Returns the greatest tension over pi w R* by Carpick, Ogletree & Salmeron 1999 (J. Colloid Interface Sci.
/// 211:395), as a magnitude [1]: 2 for DMT, 1.5 for JKR, in between within 2 % of the law.
[[nodiscard]] double carpick_pull_off(double lambda);

/// Which limit of adhesion a contact is near; Johnson & Greenwood 1997 (J. Colloid Interface Sci. 192:326).
enum class AdhesionRegime {
    none,     ///< no work of adhesion
    dmt,      ///< Tabor parameter below dmt_limit: hard and small, attraction acts around the contact
    between,  ///< neither limit holds
    jkr,      ///< Tabor parameter above jkr_limit: soft and large, attraction acts within the contact
};

template <>
struct Names<AdhesionRegime> {
    static constexpr std::string_view kind = "adhesion regime";
    static constexpr std::array<std::string_view, 4> all{"none", "dmt", "between", "jkr"};
};

/// Tabor parameters between these belong to neither limit (Johnson & Greenwood 1997): DMT below, JKR above.
inline constexpr double dmt_limit = 0.1;
inline constexpr double jkr_limit = 5.0;

/// Whether a Tabor parameter is nearer to the limit of JKR than to that of DMT, in its logarithm.
[[nodiscard]] constexpr bool nearer_to_jkr(double tabor) {
    return tabor * tabor > dmt_limit * jkr_limit;
}

/// How far a law is to be trusted for a contact: the reason, in order of preference. Of several laws the one
/// with the least value is reported.
enum class Trust {
    describes_yield,       ///< the contact yields, and the law describes it
    every_tabor,           ///< the law holds for every Tabor parameter
    no_adhesion,           ///< the contact has no adhesion, nor has the law
    nearer_limit,          ///< the law is the limit that is nearer
    nearer_limit_elastic,  ///< the same, of a law whose yielding is not used
    farther_limit,
    farther_limit_elastic,
    empirical,             ///< its adhesion is empirical, and depends on the work of adhesion
    empirical_parameters,  ///< its adhesion is empirical, and depends on parameters of the law alone
    leaves_adhesion_out,   ///< the contact has adhesion, the law has none
};

/// Normal pressure under a contact [Pa], positive where it pushes the bodies apart:
///
///     p(r) = p_0 (1 - r^2/a^2)^(1/2) - p_0' (1 - r^2/a^2)^(-1/2)
///            - (sigma_0/pi) arccos((2a^2 - c^2 - r^2)/(c^2 - r^2)) - k_c
///
/// for r < a, and -sigma_0 for a < r < c. First term: Hertz, p_0 = 2 E* a/(pi R*) (Dong et al. 2013, Eqs.
/// 3-5). Second: JKR, p_0' = sqrt(2 w E*/(pi a)) (Eq. 17). Third: Maugis-Dugdale (Maugis 1992). Fourth:
/// the cohesion of sjkr, the same all over the contact. A law has the first term and at most one of the
/// others. DMT and Brach-Dunn attract around the contact and have only the first.
struct PressureProfile {
    double contact_radius = 0;   ///< a [m]
    double outer_radius = 0;     ///< c, beyond which there is no traction; a without a cohesive zone [m]
    double hertz_pressure = 0;   ///< p_0 [Pa]
    double rim_tension = 0;      ///< p_0' [Pa]
    double cohesive_stress = 0;  ///< sigma_0 [Pa]
    double even_tension = 0;     ///< k_c [Pa]

    /// p(r) [Pa]; minus infinity at the rim of a JKR contact. @param radius r >= 0 [m]
    [[nodiscard]] double at(double radius) const;
    /// Pressure in the centre, the greatest there is [Pa].
    [[nodiscard]] double central() const { return at(0.0); }
    /// r_c = a sqrt(1 - q_0), q_0 = p_0'/p_0: the pressure of Eq. 17 pushes within and pulls beyond [m]; 0 if
    /// it pulls everywhere. For the first two terms.
    [[nodiscard]] double neutral_radius() const;
    /// Integral of p(r) over the area, in closed form [N]: Eq. 8 for Hertz, Eq. 19 for JKR.
    [[nodiscard]] double force() const;
};

/// Returns the pressure under a Hertz contact of radius @p a [m]. Eqs. 3 to 5.
[[nodiscard]] PressureProfile hertz_pressure(const ContactPair& contact, double a);

/// Returns the pressure under a JKR contact of radius @p a [m], of Hertz for a = 0. Eq. 17.
[[nodiscard]] PressureProfile jkr_pressure(const ContactPair& contact, double a);

/// Returns the pressure under a Maugis-Dugdale contact of radius @p a [m].
/// @param lambda transition parameter > 0 [1]
[[nodiscard]] PressureProfile maugis_dugdale_pressure(const ContactPair& contact, double lambda, double a);

/// Returns the radii of a JKR contact under a force, Eq. 15 [m]: first that with + before the root, where the
/// contact is stable under the force; then, up to the force of the fold -(5/6) pi w R*, that with -. None
/// beyond the greatest tension -(3/2) pi w R*. @param force positive where it pushes the bodies apart [N]
[[nodiscard]] std::vector<double> jkr_radii(const ContactPair& contact, double force);

}  // namespace ashimpact
