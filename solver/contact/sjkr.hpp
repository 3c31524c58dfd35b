// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>

#include "core/quantities/parameter.hpp"
#include "solver/contact/hertz.hpp"

namespace ashimpact {

/// Cohesion energy density k_c of Sjkr.
inline constexpr LawParameter cohesion_energy_density{
    .name = "cohesion_energy_density",
    .dimension = Dimension::pressure,
    .description = "k_c, cohesion energy per volume (J/m3 is Pa)",
    .example = "100 MJ/m3",
    .typical = 1e8,
    .may_be_zero = true,
};

/// "Simplified JKR" of DEM codes: Hertz repulsion and an attraction k_c pi a^2 in proportion to the contact
/// area, a^2 = R* delta. LIGGGHTS (cohesion sjkr) takes the area of intersection, twice as large at a wall.
/// No work of adhesion enters. Validity: an empirical closure; it has neither a pull-off force nor
/// hysteresis.
template <class Real>
struct Sjkr : Hertz<Real> {
    static constexpr std::string_view name = "sjkr";
    static constexpr std::string_view summary = "attraction grows with the contact area: a fit of DEM codes";
    static constexpr std::array parameters{cohesion_energy_density};

    [[nodiscard]] static Trust trust(double /*tabor*/, bool /*yields*/) {
        return Trust::empirical_parameters;
    }
    /// Hertz less k_c all over the contact.
    [[nodiscard]] static PressureProfile pressure(const ContactPair& pair, double a) {
        PressureProfile profile = hertz_pressure(pair, a);
        profile.even_tension = pair.parameters[cohesion_energy_density];
        return profile;
    }

    /// Adhesion number pi k_c R*/(k L^(1/2)) [1] where L is @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Real(std::numbers::pi) * pair.parameters[cohesion_energy_density] * pair.effective_radius /
               (hertz_stiffness(pair) * root<2>(length));
    }

    /// Attraction |F_a| [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& u) const {
        return this->adhesion * power<4>(u);
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u) - attraction(u);
    }

    /// State u at which the static contact ends by that rule; none if the law has no such point.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_force) return root<2>(this->adhesion);
        if (detachment == Detachment::load_controlled) return root<2>(this->adhesion * Real(2) / Real(3));
        return Hertz<Real>::detachment_point(detachment);
    }
};

}  // namespace ashimpact
