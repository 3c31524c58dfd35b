#pragma once

#include "solver/contact/detachment.hpp"
#include "solver/contact/pair.hpp"
#include "solver/numeric/power.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace ashimpact {

/// Johnson, Kendall & Roberts 1971; Dong et al. 2013, Eqs. 15-20, normalised Eqs. 25-27.
///
/// delta = a^2/R* - sqrt(2 pi w a/E*), F = K a^3/R* - sqrt(8 pi w E* a^3), K = (4/3) E*. Normalisation and
/// state as in Hertz: polynomials through first touch (u^3 = adhesion, delta = 0), turning point and the fold
/// (u^3 = adhesion/4). Validity: large Tabor parameter (soft, large spheres, short-ranged attraction).
template <class Real>
struct Jkr {
    static constexpr std::string_view name = "jkr";
    static constexpr Detachment default_detachment = Detachment::pull_off;

    Real adhesion;  ///< sqrt(2 pi w/E*) R*^(1/4) L^(-3/4) [1]

    /// Adhesion number of the law for lengths in @p length [m].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>& pair, const Real& length) {
        return root<2>(Real(2.0 * std::numbers::pi) * pair.work_of_adhesion / pair.contact_modulus) *
               root<4>(pair.effective_radius) / power<3>(root<4>(length));
    }

    /// Overlap, positive in contact, negative on the neck before it breaks [L].
    template <class U>
    [[nodiscard]] constexpr U overlap(const U& u) const {
        return power<4>(u) - adhesion * u;
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u) - (adhesion * Real(1.5)) * power<3>(u);
    }
    /// Attractive part of the force: the tensile rim of Eq. 18, all of the force where the contact is tensile
    /// throughout (u^3 <= adhesion/2, Eq. 26) [k L^(3/2)].
    [[nodiscard]] Real attractive_force(const Real& u) const {
        using std::sqrt;
        if (Real(2) * power<3>(u) <= adhesion) return force(u);
        const Real rim = adhesion * u;
        return -rim * sqrt(rim / Real(2));
    }

    /// State at first touch: zero overlap, reached by the jump to a finite contact radius.
    [[nodiscard]] Real touch() const { return root<3>(adhesion); }

    /// State at which the static law detaches.
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
