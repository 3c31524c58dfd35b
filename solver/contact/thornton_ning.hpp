// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "solver/contact/jkr.hpp"

namespace ashimpact {

template <class Real>
struct PlasticLoading;
template <class Real>
struct YieldedContact;

/// Thornton & Ning 1998 (Powder Technol. 99:154): adhesive, elastic-perfectly plastic sphere.
///
/// Loading is JKR until the pressure in the centre reaches the yield pressure p_y, at the contact radius a_y:
/// p_y = 2 E* a_y/(pi R*) - sqrt(2 w E*/(pi a_y)). Unloading is JKR of the sphere flattened to the radius R_p
/// that makes force and contact radius continuous at greatest overlap. It breaks at the fold of that curve,
/// so adhesion acts with R_p. Without adhesion, plastic loading is Thornton & Ning's closed form. With
/// adhesion it is closed here: JKR is a Hertz contact plus the retraction of a flat punch; the Hertz part
/// yields, so each further ring of contact adds the pressure p_y + sqrt(2 w E*/(pi a)) to it, and the punch
/// part stays elastic. Loading is then smooth at yield and flattening never negative
/// (docs/decisions/0003-plastic-closure.md). This type is the elastic branch, that of Jkr; PlasticLoading and
/// YieldedContact have the others. The pressure is that of Jkr, or p_y where that would be greater.
template <class Real>
struct ThorntonNing : Jkr<Real> {
    static constexpr std::string_view name = "thornton-ning";
    static constexpr std::string_view summary = "jkr, and plastic deformation above a yield pressure";
    static constexpr bool is_plastic = true;
    /// The branch from the yield point on, and the contact that has both.
    template <class U>
    using Loading = PlasticLoading<U>;
    template <class U>
    using Yielded = YieldedContact<U>;

    [[nodiscard]] static Trust trust(double tabor, bool yields) {
        if (yields) return Trust::describes_yield;
        return nearer_to_jkr(tabor) ? Trust::nearer_limit_elastic : Trust::farther_limit_elastic;
    }

    /// Yield number [1]: the contact radius at which a Hertz contact yields over sqrt(R* L),
    /// pi R* p_y/(2 E* sqrt(R* L)).
    [[nodiscard]] static Real yield_number(const BasicContactPair<Real>& pair, const Real& length) {
        return Real(0.5 * std::numbers::pi) * pair.yield_pressure / pair.contact_modulus *
               root<2>(pair.effective_radius / length);
    }

    /// Third number of scaled impacts beside adhesion and damping [1], free of the velocity: c =
    /// A^(1/3)/Y^(1/2) of adhesion and yield number. 0 without adhesion; sqrt(2) where adhesion alone yields
    /// the contact.
    [[nodiscard]] static Real yield_adhesion(const BasicContactPair<Real>& pair) {
        const Real& any_length = pair.effective_radius;
        return root<3>(Jkr<Real>::adhesion_number(pair, any_length)) /
               root<2>(yield_number(pair, any_length));
    }

    /// State u at which the elastic branch ends by that rule. None for zero overlap, to which a flattened
    /// sphere does not return.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_overlap) return std::nullopt;
        return Jkr<Real>::detachment_point(detachment);
    }
};

/// The plastic loading branch of ThorntonNing, normalised. Overlap and attraction are the elastic branch's
/// functions of the contact radius.
template <class Real>
struct PlasticLoading : Jkr<Real> {
    Real offset;                  ///< of the Hertz part of the force [k L^(3/2)]
    Real yield_number = Real(1);  ///< as in ThorntonNing; 1 in units of the length at which it is [1]

    /// Hertz part of the force [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U repulsion(const U& u) const {
        return (Real(1.5) * yield_number) * power<4>(u) + this->adhesion * power<3>(u) - offset;
    }
    /// Total static force, positive where repulsive [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return repulsion(u) - this->attraction(u);
    }
    /// Flattening R*/R_p <= 1 after loading to @p u [1].
    [[nodiscard]] Real flattening(const Real& u) const { return repulsion(u) / power<6>(u); }
};

/// A contact that yields, normalised.
template <class Real>
struct YieldedContact {
    Real adhesion;      ///< as in Jkr [1]
    Real yield_number;  ///< as in ThorntonNing [1]

    /// State u_y at which the elastic branch reaches p_y, the root of u^3 - yield_number u - adhesion/2.
    [[nodiscard]] Real yield_point() const {
        using std::max;
        // Newton from above on a function that is convex there: seven steps from within a factor of 1.5 of
        // the root.
        Real u = max(root<2>(yield_number), root<3>(adhesion / Real(2))) * Real(1.5);
        for (int i = 0; i < 8; ++i)
            u = u - (power<3>(u) - yield_number * u - adhesion / Real(2)) / (Real(3) * u * u - yield_number);
        return u;
    }
    /// The branch from that state on.
    [[nodiscard]] PlasticLoading<Real> loading() const {
        const Real u = yield_point();
        return {{adhesion}, (yield_number * u + adhesion) * power<3>(u) / Real(2), yield_number};
    }
};

}  // namespace ashimpact
