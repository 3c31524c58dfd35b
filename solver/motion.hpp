#pragma once

#include "solver/contact/detachment.hpp"
#include "solver/damping/damping.hpp"
#include "solver/numeric/polynomial.hpp"

#include <limits>
#include <optional>

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
    std::optional<Real> end;     ///< q at which the contact ends; none: not a place but total force zero
    bool squared = false;        ///< q = u^2
};

/// Builds the equation of motion from the law's own lines.
/// @param adhesion, damping_number scaled coefficients [1]
template <template <class> class L, class Real>
[[nodiscard]] Motion<Real> make_motion(Real adhesion, DampingLaw damping_law, Real damping_number,
                                       Detachment detachment) {
    const L<Real> numeric{adhesion};
    const L<Polynomial<Real>> law{Polynomial<Real>(adhesion)};
    const auto u = Polynomial<Real>::identity();

    Motion<Real> motion;
    motion.overlap = law.overlap(u);
    motion.force = law.force(u);
    switch (damping_law) {
        case DampingLaw::constant:
            motion.damping = damping_number;
            break;
        case DampingLaw::contact_radius:
            motion.damping = damping_number * (u * u);
            break;
        case DampingLaw::tsuji:
            motion.damping = damping_number * u;
            break;
    }
    motion.squared = motion.overlap.even() && motion.force.even() && motion.damping.even();
    if (motion.squared) {
        motion.overlap = motion.overlap.of_square();
        motion.force = motion.force.of_square();
        motion.damping = motion.damping.of_square();
    }
    motion.slope = motion.overlap.derivative();
    motion.stiffness = motion.slope * motion.force;
    motion.drag = motion.slope * motion.damping;
    motion.potential = motion.stiffness.antiderivative();

    const auto place = [&](Real state) { return motion.squared ? state * state : state; };
    motion.touch = place(numeric.touch());
    motion.equilibrium = place(*numeric.detachment_point(Detachment::zero_force));
    const bool by_force = detachment == Detachment::zero_force && damping_number != Real(0);
    if (!by_force) motion.end = place(*numeric.detachment_point(detachment));
    return motion;
}

}  // namespace ashimpact
