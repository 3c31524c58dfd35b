// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/batch/lanes/symbol.hpp"
#include "solver/damping/registry.hpp"

namespace ashimpact {

/// The scaled equation of motion of a contact law and a damping law, known at compile time but for the
/// adhesion number A and the damping number beta; in the coordinate q of Motion:
///
///     dq/dtheta = y - beta g(q),   dy/dtheta = -h(q),   dt/dtheta = delta'(q),   h = delta' F,  g' = delta'
///     eta/beta.
///
/// y = v + beta g(q) is velocity plus the impulse damping has taken since q = 0 (Lienard's variable). In (q,
/// y) no product of two unknowns is left, and each rate depends on one of the two through q alone: the
/// leapfrog's form.
template <template <class> class L, class DampingType>
struct Form {
    template <class Real>
    using ContactLaw = L<Real>;
    using Damping = DampingType;

  private:
    static constexpr L<Symbol> law{Symbol::monomial(0, 1)};
    static constexpr Symbol u = Symbol::monomial(1, 0);
    static constexpr Symbol shape_of_u = Damping::shape(u);

  public:
    /// q = u^2, u = sqrt(contact radius).
    static constexpr bool squared = law.overlap(u).even() && law.force(u).even() && shape_of_u.even();

  private:
    static constexpr Symbol reduced(const Symbol& p) { return squared ? p.of_square() : p; }

  public:
    static constexpr Symbol overlap = reduced(law.overlap(u));         ///< delta(q)
    static constexpr Symbol force = reduced(law.force(u));             ///< F(q)
    static constexpr Symbol force_slope = force.derivative();          ///< F'(q)
    static constexpr Symbol damping_of_state = reduced(shape_of_u);    ///< eta(q)/beta
    static constexpr Symbol slope = overlap.derivative();              ///< delta'(q)
    static constexpr Symbol stiffness = slope * force;                 ///< h(q)
    static constexpr Symbol drag = slope * damping_of_state;           ///< g'(q)
    static constexpr Symbol impulse = drag.antiderivative();           ///< g(q)
    static constexpr Symbol stiffness_slope = stiffness.derivative();  ///< h'(q)
    static constexpr Symbol drag_slope = drag.derivative();            ///< g''(q)
    static constexpr Symbol potential = stiffness.antiderivative();    ///< U(q)
};

/// Calls @p call with the Form of a contact law and a damping law.
template <template <class> class L, class Call>
void with_form(DampingLaw damping_law, const Call& call) {
    RegisteredDampings::visit<void>(damping_law, [&]<class Damping>() { call(Form<L, Damping>()); });
}

}  // namespace ashimpact
