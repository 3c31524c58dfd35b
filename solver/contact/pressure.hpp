// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/contact/pair.hpp"

namespace ashimpact {

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

}  // namespace ashimpact
