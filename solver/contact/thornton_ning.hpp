// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "solver/contact/jkr.hpp"

namespace ashimpact {

/// Thornton & Ning 1998 (Powder Technol. 99:154): adhesive, elastic-perfectly plastic sphere.
///
/// Loading is JKR until the pressure in the centre reaches the yield pressure p_y, at the contact radius a_y:
/// p_y = 2 E* a_y/(pi R*) - sqrt(2 w E*/(pi a_y)). Unloading is JKR of the sphere flattened to the radius R_p
/// that makes force and contact radius continuous at greatest overlap. It breaks at the fold of that curve,
/// so adhesion acts with R_p. Without adhesion, plastic loading is Thornton & Ning's closed form. With
/// adhesion it is closed here: JKR is a Hertz contact plus the retraction of a flat punch; the Hertz part
/// yields, so each further ring of contact adds the pressure p_y + sqrt(2 w E*/(pi a)) to it, and the punch
/// part stays elastic. Loading is then smooth at yield and flattening never negative
/// (docs/decisions/0003-plastic-closure.md). This type is the elastic branch, that of Jkr; YieldedContact has
/// the others. The pressure is that of Jkr, or p_y where that would be greater.
template <class Real>
struct ThorntonNing : Jkr<Real> {
    static constexpr std::string_view name = "thornton-ning";
    static constexpr std::string_view summary = "jkr, and plastic deformation above a yield pressure";
    static constexpr bool is_plastic = true;

    [[nodiscard]] static Trust trust(double tabor, bool yields) {
        if (yields) return Trust::describes_yield;
        return nearer_to_jkr(tabor) ? Trust::nearer_limit_elastic : Trust::farther_limit_elastic;
    }

    /// Yield number [1]: the contact radius at which a Hertz contact yields over sqrt(R* L),
    /// pi R* p_y/(2 E* sqrt(R* L)).
    [[nodiscard]] static double yield_number(const ContactPair& pair, double length) {
        return std::numbers::pi * pair.yield_pressure / (2.0 * pair.contact_modulus) *
               std::sqrt(pair.effective_radius / length);
    }

    /// State u at which the elastic branch ends by that rule. None for zero overlap, to which a flattened
    /// sphere does not return.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_overlap) return std::nullopt;
        return Jkr<Real>::detachment_point(detachment);
    }
};

/// The history of one yielded contact: plastic loading, then unloading on the flattened sphere; normalised.
template <class Real>
struct YieldedContact {
    Real adhesion;      ///< as in Jkr [1]
    Real yield_number;  ///< as in ThorntonNing [1]

    /// State u_y at which the elastic branch reaches p_y, the root of u^3 - yield_number u - adhesion/2.
    [[nodiscard]] Real yield_point() const {
        using std::abs;
        using std::max;
        // Newton from above on a function that is convex there.
        Real u = max(root<2>(yield_number), root<3>(adhesion / Real(2))) * Real(1.5);
        for (int i = 0; i < 100; ++i) {
            const Real step =
                (power<3>(u) - yield_number * u - adhesion / Real(2)) / (Real(3) * u * u - yield_number);
            u -= step;
            if (!(abs(step) > Real(0)) || abs(step) <= std::numeric_limits<Real>::epsilon() * u) break;
        }
        return u;
    }
    /// Overlap on the plastic branch, the same function of contact radius as on the elastic one [L].
    template <class U>
    [[nodiscard]] U plastic_overlap(const U& u) const {
        return power<4>(u) - adhesion * u;
    }
    /// Hertz part of the force on the plastic branch [k L^(3/2)].
    template <class U>
    [[nodiscard]] U plastic_hertz_force(const U& u) const {
        const Real at_yield = yield_point();
        const Real half_yield = (yield_number * power<4>(at_yield) + adhesion * power<3>(at_yield)) / Real(2);
        return (Real(1.5) * yield_number) * power<4>(u) + adhesion * power<3>(u) - half_yield;
    }
    /// Attraction on every branch, the punch part of JKR, positive [k L^(3/2)].
    template <class U>
    [[nodiscard]] U attraction(const U& u) const {
        return (Real(1.5) * adhesion) * power<3>(u);
    }
    /// Force on the plastic branch [k L^(3/2)].
    template <class U>
    [[nodiscard]] U plastic_force(const U& u) const {
        return plastic_hertz_force(u) - attraction(u);
    }
    /// Flattening R*/R_p <= 1 after loading to @p u [1].
    [[nodiscard]] Real flattening(const Real& u) const { return plastic_hertz_force(u) / power<6>(u); }
    /// Permanent overlap delta_p after loading to @p u [L].
    [[nodiscard]] Real permanent_overlap(const Real& u) const {
        return power<4>(u) * (Real(1) - flattening(u));
    }
};

}  // namespace ashimpact
