// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string_view>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// Brach & Dunn 1995: Hertz repulsion and a line attraction 2 pi a f on the rim of the contact;
/// Dong et al. 2013, Eqs. 12-14, normalised Eq. 24. Normalisation and state as in Hertz. Validity: empirical.
template <class Real>
struct BrachDunn {
    static constexpr std::string_view name = "brach-dunn";
    static constexpr Detachment default_detachment = Detachment::zero_overlap;
    static constexpr bool uses_work_of_adhesion = true;

    Real adhesion;  ///< 2 pi f sqrt(R*) / (k L), f = (6 w^2 R* E* / pi)^(1/3) [1]

    [[nodiscard]] static Trust trust(double /*tabor*/, bool /*yields*/) { return Trust::empirical; }
    /// Hertz: the attraction acts on the rim of the contact.
    [[nodiscard]] static PressureProfile pressure(const ContactPair& pair, double a) {
        return hertz_pressure(pair, a);
    }

    /// Line tension f = (6 w^2 R* E*/pi)^(1/3) [N/m]; Eq. 14.
    [[nodiscard]] static Real line_tension(const BasicContactPair<Real>& pair) {
        const Real w = pair.work_of_adhesion;
        return root<3>(Real(6.0 / std::numbers::pi) * w * w * pair.effective_radius * pair.contact_modulus);
    }
    /// Adhesion number [1] where L is @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Real(2.0 * std::numbers::pi) * line_tension(pair) * root<2>(pair.effective_radius) /
               (hertz_stiffness(pair) * length);
    }

    /// Overlap, positive in contact [L].
    template <class U>
    [[nodiscard]] constexpr U overlap(const U& u) const {
        return power<4>(u);
    }
    /// Attraction |F_a|, Eq. 13 [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& u) const {
        return adhesion * power<2>(u);
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u) - attraction(u);
    }

    /// State u at first touch.
    [[nodiscard]] Real touch() const { return Real{}; }

    /// State u at which the static contact ends by that rule; none if the law has no such point.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_overlap) return Real{};
        if (detachment == Detachment::zero_force) return root<4>(adhesion);
        if (detachment == Detachment::load_controlled) return root<4>(adhesion / Real(3));
        return std::nullopt;
    }
};

}  // namespace ashimpact
