#pragma once

#include "solver/contact/detachment.hpp"
#include "solver/contact/pair.hpp"
#include "solver/numeric/power.hpp"

#include <optional>
#include <string_view>

namespace ashimpact {

/// Hertz contact without adhesion, F = k delta^(3/2); Dong et al. 2013, Eqs. 3-9, normalised Eq. 22.
///
/// Normalised as every law here: lengths in L, forces in k L^(3/2), contact radius in sqrt(R* L), and the
/// state is u = sqrt(contact radius), in which overlap and force are polynomials. Validity: contact radius <<
/// R*.
template <class Real>
struct Hertz {
    static constexpr std::string_view name = "hertz";
    static constexpr Detachment default_detachment = Detachment::zero_overlap;

    Real adhesion{};  ///< unused: the law has no attraction

    /// Adhesion number of the law for lengths in @p length [m]: none [1].
    [[nodiscard]] static Real adhesion_number(const BasicContactPair<Real>&, const Real& /*length*/) {
        return Real(0);
    }

    /// Overlap, positive in contact [L].
    template <class U>
    [[nodiscard]] constexpr U overlap(const U& u) const {
        return power<4>(u);
    }
    /// Total static force, positive where repulsive [k L^(3/2)]; Eq. 9.
    template <class U>
    [[nodiscard]] constexpr U force(const U& u) const {
        return power<6>(u);
    }
    /// Attractive part of the force, never positive [k L^(3/2)].
    [[nodiscard]] Real attractive_force(const Real& /*u*/) const { return Real{}; }

    /// State at first touch.
    [[nodiscard]] Real touch() const { return Real{}; }

    /// State at which the static law detaches; none where the law has no such point.
    [[nodiscard]] std::optional<Real> detachment_point(Detachment detachment) const {
        if (detachment == Detachment::zero_overlap || detachment == Detachment::zero_force) return Real{};
        return std::nullopt;
    }
};

}  // namespace ashimpact
