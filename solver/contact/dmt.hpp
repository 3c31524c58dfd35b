// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "solver/contact/hertz.hpp"

namespace ashimpact {

/// Derjaguin, Muller & Toporov 1975: Hertz repulsion and a constant attraction 2 pi w R*, which acts around
/// the contact; Dong et al. 2013, Eqs. 10-11, normalised Eq. 23. Validity: Tabor parameter below 0.1 (hard,
/// small spheres, long-ranged attraction).
template <class Real>
struct Dmt : Hertz<Real> {
    static constexpr std::string_view name = "dmt";
    static constexpr std::string_view summary =
        "hard, small particles; the attraction acts around the contact";
    static constexpr bool uses_work_of_adhesion = true;
    static constexpr AdhesionRegime limit = AdhesionRegime::dmt;

    [[nodiscard]] static Trust trust(double tabor, bool /*yields*/) {
        return nearer_to_jkr(tabor) ? Trust::farther_limit : Trust::nearer_limit;
    }

    /// Adhesion number 2 pi w R*/(k L^(3/2)) [1] where L is @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Real(2.0 * std::numbers::pi) * pair.work_of_adhesion * pair.effective_radius /
               (hertz_stiffness(pair) * length * root<2>(length));
    }

    /// Attraction |F_a|, Eq. 11 [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& /*u*/) const {
        return this->adhesion;
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u) - attraction(u);
    }

    /// State u at which the static contact ends by that rule; none if the law has no such point.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_force) return root<6>(this->adhesion);
        return Hertz<Real>::detachment_point(detachment);
    }
};

}  // namespace ashimpact
