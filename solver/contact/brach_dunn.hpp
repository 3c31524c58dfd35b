// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "solver/contact/hertz.hpp"

namespace ashimpact {

/// Brach & Dunn 1995: Hertz repulsion and a line attraction 2 pi a f on the rim of the contact;
/// Dong et al. 2013, Eqs. 12-14, normalised Eq. 24. Validity: empirical.
template <class Real>
struct BrachDunn : Hertz<Real> {
    static constexpr std::string_view name = "brach-dunn";
    static constexpr std::string_view summary =
        "attraction along the rim of the contact: a fit, not a theory";
    static constexpr bool uses_work_of_adhesion = true;

    [[nodiscard]] static Trust trust(double /*tabor*/, bool /*yields*/) { return Trust::empirical; }

    /// Line tension f = (6 w^2 R* E*/pi)^(1/3) [N/m]; Eq. 14.
    [[nodiscard]] static Real line_tension(const BasicContactPair<Real>& pair) {
        const Real w = pair.work_of_adhesion;
        return root<3>(Real(6.0 / std::numbers::pi) * w * w * pair.effective_radius * pair.contact_modulus);
    }
    /// Adhesion number 2 pi f sqrt(R*)/(k L) [1] where L is @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Real(2.0 * std::numbers::pi) * line_tension(pair) * root<2>(pair.effective_radius) /
               (hertz_stiffness(pair) * length);
    }

    /// Attraction |F_a|, Eq. 13 [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& u) const {
        return this->adhesion * power<2>(u);
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u) - attraction(u);
    }

    /// State u at which the static contact ends by that rule; none if the law has no such point.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_force) return root<4>(this->adhesion);
        if (detachment == Detachment::load_controlled) return root<4>(this->adhesion / Real(3));
        return Hertz<Real>::detachment_point(detachment);
    }
};

}  // namespace ashimpact
