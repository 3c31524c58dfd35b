// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// Hertz contact without adhesion, F = k delta^(3/2); Dong et al. 2013, Eqs. 3-9, normalised Eq. 22.
///
/// Every law here is normalised by a length L that the caller chooses (see BasicScale): overlaps are in units
/// of L, forces in k L^(3/2), contact radii in sqrt(R* L). The state is u = sqrt(contact radius) in these
/// units; overlap and force are polynomials of u. Laws with the overlap of Hertz derive from it. Validity:
/// contact radius << R*.
template <class Real>
struct Hertz {
    static constexpr std::string_view name = "hertz";
    static constexpr std::string_view summary = "elastic, without adhesion";
    static constexpr Detachment default_detachment = Detachment::zero_overlap;
    static constexpr bool uses_work_of_adhesion = false;

    Real adhesion{};  ///< the law's adhesion number [1]; not used here

    [[nodiscard]] static Trust trust(double tabor, bool /*yields*/) {
        return tabor > 0 ? Trust::leaves_adhesion_out : Trust::no_adhesion;
    }
    [[nodiscard]] static PressureProfile pressure(const ContactPair& pair, double a) {
        return hertz_pressure(pair, a);
    }

    /// Adhesion number [1]: 0.
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>&, const Real& /*length*/) {
        return Real(0);
    }

    /// Overlap, positive in contact [L].
    template <class U>
    [[nodiscard]] constexpr U overlap(const U& u) const {
        return power<4>(u);
    }
    /// Attraction |F_a| [k L^(3/2)].
    template <class U>
    [[nodiscard]] constexpr U attraction(const U& /*u*/) const {
        return U(0);
    }
    /// Total static force, positive where repulsive [k L^(3/2)]; Eq. 9.
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u);
    }

    /// State u at first touch.
    [[nodiscard]] Real touch() const { return Real{}; }

    /// State u at which the static contact ends by that rule; none if the law has no such point.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_overlap || detachment == Detachment::zero_force) return Real{};
        return std::nullopt;
    }
};

}  // namespace ashimpact
