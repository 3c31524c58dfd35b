// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "solver/damping/damping.hpp"
#include "solver/numeric/number.hpp"
#include "solver/numeric/polynomial.hpp"

namespace ashimpact {

/// One branch of a static law as polynomials of u = sqrt(contact radius), scaled; or a piece of one, where
/// the polynomials change along the way.
template <class Real>
struct StaticBranch {
    Polynomial<Real> overlap;                            ///< delta(u)
    StaticForces<Polynomial<Real>> forces;               ///< F(u) = F_r - |F_a|
    Real until = std::numeric_limits<Real>::infinity();  ///< u up to which they hold
};

/// The static law L as polynomials: one piece, or those of a law that has `pieces()`.
/// @param adhesion adhesion number [1]
template <template <class> class L, class Real>
[[nodiscard]] auto static_branches(Real adhesion) {
    if constexpr (requires(const L<Real>& law) { law.pieces(); }) {
        return L<Real>{adhesion}.pieces();
    } else {
        const L<Polynomial<Real>> law{Polynomial<Real>(adhesion)};
        const auto u = Polynomial<Real>::identity();
        return std::array{StaticBranch<Real>{law.overlap(u), {power<6>(u), law.attraction(u)}}};
    }
}

}  // namespace ashimpact
