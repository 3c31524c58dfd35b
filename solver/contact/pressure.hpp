#pragma once

#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact {

/// Normal pressure under a contact [Pa], positive where it pushes the bodies apart:
///
///     p(r) = p_0 (1 - r^2/a^2)^(1/2) - p_0' (1 - r^2/a^2)^(-1/2) - (sigma_0/pi) arccos((2a^2 - c^2 -
///     r^2)/(c^2 - r^2))
///
/// for r < a, and -sigma_0 for a < r < c. First term: Hertz, p_0 = 2 E* a/(pi R*) (Dong et al. 2013, Eqs.
/// 3-5). Second: JKR, p_0' = sqrt(2 w E*/(pi a)) (Eq. 17). Third: Maugis-Dugdale (Maugis 1992). Attraction
/// that acts around the contact (DMT, Brach-Dunn) leaves the pressure of Hertz within it.
struct PressureProfile {
    double contact_radius = 0;   ///< a [m]
    double outer_radius = 0;     ///< c, beyond which there is no traction; a but for a cohesive zone [m]
    double hertz_pressure = 0;   ///< p_0 [Pa]
    double rim_tension = 0;      ///< p_0' [Pa]
    double cohesive_stress = 0;  ///< sigma_0 [Pa]

    /// p(r) [Pa]; minus infinity at the rim of a JKR contact. @param radius r >= 0 [m]
    [[nodiscard]] double at(double radius) const;
    /// Pressure in the centre, the greatest there is [Pa].
    [[nodiscard]] double central() const { return at(0.0); }
    /// Force that the tractions add up to, by their closed integrals [N]: Eq. 8 for Hertz, Eq. 19 for JKR.
    [[nodiscard]] double force() const;
};

/// Returns the pressure under a Hertz contact of radius @p a [m]. Eqs. 3 to 5.
[[nodiscard]] PressureProfile hertz_pressure(const ContactPair& contact, double a);

/// Returns the pressure under a JKR contact of radius @p a [m]. Eq. 17.
[[nodiscard]] PressureProfile jkr_pressure(const ContactPair& contact, double a);

/// Returns the pressure that a law has under a contact of radius @p a that has not yielded [m]: JKR of jkr
/// and thornton-ning, Maugis-Dugdale of that law, Hertz of all others.
[[nodiscard]] PressureProfile pressure_profile(Law law, const ContactPair& contact, double a);

/// Returns the pressure under a Maugis-Dugdale contact of radius @p a [m].
/// @param lambda transition parameter > 0 [1]
[[nodiscard]] PressureProfile maugis_dugdale_pressure(const ContactPair& contact, double lambda, double a);

}  // namespace ashimpact
