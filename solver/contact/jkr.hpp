// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// Johnson, Kendall & Roberts 1971; Dong et al. 2013, Eqs. 15-20, normalised Eqs. 25-27.
///
/// delta = a^2/R* - sqrt(2 pi w a/E*), F = K a^3/R* - sqrt(8 pi w E* a^3), K = (4/3) E*. Normalisation and
/// state as in Hertz; both are polynomials of u from first touch (u^3 = adhesion, delta = 0) to the fold
/// (u^3 = adhesion/4). Validity: Tabor parameter above 5 (soft, large spheres, short-ranged attraction).
template <class Real>
struct Jkr {
    static constexpr std::string_view name = "jkr";
    static constexpr std::string_view summary =
        "soft, large particles; the attraction acts within the contact";
    static constexpr Detachment default_detachment = Detachment::pull_off;
    static constexpr bool uses_work_of_adhesion = true;
    static constexpr AdhesionRegime limit = AdhesionRegime::jkr;

    Real adhesion;  ///< sqrt(2 pi w/E*) R*^(1/4) L^(-3/4) [1]

    [[nodiscard]] static Trust trust(double tabor, bool /*yields*/) {
        return nearer_to_jkr(tabor) ? Trust::nearer_limit : Trust::farther_limit;
    }
    [[nodiscard]] static PressureProfile pressure(const ContactPair& pair, double a) {
        return jkr_pressure(pair, a);
    }

    /// Adhesion number [1] where L is @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return root<2>(Real(2.0 * std::numbers::pi) * pair.work_of_adhesion / pair.contact_modulus) *
               root<4>(pair.effective_radius) / power<3>(root<4>(length));
    }

    /// Overlap, positive in contact, negative on the neck before it breaks [L].
    template <class U>
    [[nodiscard]] constexpr U overlap(const U& u) const {
        return power<4>(u) - adhesion * u;
    }
    /// Attraction |F_a| [k L^(3/2)], sqrt(8 pi w E* a^3): the force of the flat punch that JKR adds to Hertz.
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& u) const {
        return (adhesion * Real(1.5)) * power<3>(u);
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u) - attraction(u);
    }
    /// Attractive part of the force as the paper divides it, never positive [k L^(3/2)]: the tensile rim of
    /// Eq. 18. Where the whole
    /// contact is tensile (u^3 <= adhesion/2, Eq. 26) it is the total force.
    [[nodiscard]] Real attractive_force(const Real& u) const {
        using std::sqrt;
        if (Real(2) * power<3>(u) <= adhesion) return force(u);
        const Real rim = adhesion * u;
        return -rim * sqrt(rim / Real(2));
    }

    /// State u at first touch: zero overlap, where the contact radius jumps from 0 to a finite value.
    [[nodiscard]] Real touch() const { return root<3>(adhesion); }

    /// State u at which the static contact ends by that rule.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        switch (detachment) {
            case Detachment::zero_overlap:
                return root<3>(adhesion);
            case Detachment::zero_force:
                return root<3>(adhesion * Real(1.5));
            case Detachment::pull_off:
                return root<3>(adhesion / Real(4));
            case Detachment::load_controlled:
                return root<3>(adhesion * Real(0.75));
        }
        return std::nullopt;
    }
};

}  // namespace ashimpact
