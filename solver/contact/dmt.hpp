// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string_view>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// Derjaguin, Muller & Toporov 1975: Hertz repulsion and a constant attraction 2 pi w R*;
/// Dong et al. 2013, Eqs. 10-11, normalised Eq. 23. Normalisation and state as in Hertz.
/// Validity: Tabor parameter below 0.1 (hard, small spheres, long-ranged attraction).
template <class Real>
struct Dmt {
    static constexpr std::string_view name = "dmt";
    static constexpr Detachment default_detachment = Detachment::zero_overlap;
    static constexpr bool uses_work_of_adhesion = true;
    static constexpr AdhesionRegime limit = AdhesionRegime::dmt;

    Real adhesion;  ///< 2 pi w R* / (k L^(3/2)) [1]

    [[nodiscard]] static Trust trust(double tabor, bool /*yields*/) {
        return nearer_to_jkr(tabor) ? Trust::farther_limit : Trust::nearer_limit;
    }
    /// Hertz: the attraction acts around the contact.
    [[nodiscard]] static PressureProfile pressure(const ContactPair& pair, double a) {
        return hertz_pressure(pair, a);
    }

    /// Adhesion number [1] where L is @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Real(2.0 * std::numbers::pi) * pair.work_of_adhesion * pair.effective_radius /
               (hertz_stiffness(pair) * length * root<2>(length));
    }

    /// Overlap, positive in contact [L].
    template <class U>
    [[nodiscard]] constexpr U overlap(const U& u) const {
        return power<4>(u);
    }
    /// Attraction |F_a|, Eq. 11 [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& /*u*/) const {
        return adhesion;
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
        if (detachment == Detachment::zero_force) return root<6>(adhesion);
        return std::nullopt;
    }
};

}  // namespace ashimpact
