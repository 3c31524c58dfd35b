// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "solver/contact/detachment.hpp"
#include "solver/damping/registry.hpp"
#include "solver/numeric/polynomial.hpp"

namespace ashimpact {

/// The equation of motion of one impact, scaled (mass 1, Hertz stiffness 1), in the regularised coordinate q:
///
///     dq/dtheta = v,   dv/dtheta = -delta'(q) (eta(q) v + F(q)),   dt/dtheta = delta'(q),   v = d(delta)/dt.
///
/// q is u = sqrt(contact radius), or u^2 where every polynomial is even in u. Nothing is singular at touch,
/// turning point or detachment.
template <class Real>
struct Motion {
    Polynomial<Real> overlap;    ///< delta(q)
    Polynomial<Real> slope;      ///< delta'(q)
    Polynomial<Real> force;      ///< F(q)
    Polynomial<Real> damping;    ///< eta(q)
    Polynomial<Real> stiffness;  ///< delta'(q) F(q) = dU/dq
    Polynomial<Real> drag;       ///< delta'(q) eta(q)
    Polynomial<Real> potential;  ///< U(q)
    Real touch{};                ///< q at first touch
    Real equilibrium{};          ///< q of the static equilibrium, the minimum of U
    std::optional<Real> end;     ///< q at which the contact ends; none if it ends at zero total force
    bool squared = false;        ///< q = u^2
    bool overdamped = false;     ///< the damping captures every impact that touches at zero contact radius

    /// q of a state u = sqrt(contact radius).
    [[nodiscard]] Real coordinate(const Real& u) const { return squared ? u * u : u; }
    /// u = sqrt(contact radius) of a coordinate q.
    [[nodiscard]] Real root_radius(const Real& q) const {
        using std::sqrt;
        return squared ? sqrt(q > Real(0) ? q : Real(0)) : q;
    }
};

/// A damping law with its scaled coefficient.
template <class Real>
struct ScaledDamping {
    DampingLaw law;
    Real number;  ///< scaled coefficient [1]

    /// eta(u), scaled [1].
    [[nodiscard]] Polynomial<Real> polynomial() const {
        const auto u = Polynomial<Real>::identity();
        return number *
               RegisteredDampings::visit<Polynomial<Real>>(law, [&]<class D>() { return D::shape(u); });
    }
};

/// The equation of motion on one branch delta(u), F(u); touch, equilibrium and end remain to be set.
template <class Real>
[[nodiscard]] Motion<Real> branch_motion(const Polynomial<Real>& overlap, const Polynomial<Real>& force,
                                         const ScaledDamping<Real>& scaled) {
    const Polynomial<Real> damping = scaled.polynomial();
    Motion<Real> motion;
    motion.overdamped = is_overdamped(scaled.law, scaled.number);
    motion.squared = overlap.even() && force.even() && damping.even();
    const auto reduced = [&](const Polynomial<Real>& p) { return motion.squared ? p.of_square() : p; };
    motion.overlap = reduced(overlap);
    motion.force = reduced(force);
    motion.damping = reduced(damping);
    motion.slope = motion.overlap.derivative();
    motion.stiffness = motion.slope * motion.force;
    motion.drag = motion.slope * motion.damping;
    motion.potential = motion.stiffness.antiderivative();
    return motion;
}

/// Builds the equation of motion from overlap and force of law L.
/// @param adhesion, damping_number scaled coefficients [1]
template <template <class> class L, class Real>
[[nodiscard]] Motion<Real> make_motion(Real adhesion, DampingLaw damping_law, Real damping_number,
                                       Detachment detachment) {
    const L<Real> numeric{adhesion};
    const L<Polynomial<Real>> law{Polynomial<Real>(adhesion)};
    const auto u = Polynomial<Real>::identity();
    Motion<Real> motion = branch_motion<Real>(law.overlap(u), law.force(u), {damping_law, damping_number});
    motion.touch = motion.coordinate(numeric.touch());
    motion.equilibrium = motion.coordinate(*numeric.detachment_point(Detachment::zero_force));
    const bool by_force = detachment == Detachment::zero_force && damping_number != Real(0);
    if (!by_force) motion.end = motion.coordinate(*numeric.detachment_point(detachment));
    return motion;
}

}  // namespace ashimpact
