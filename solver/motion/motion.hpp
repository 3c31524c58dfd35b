#pragma once

#include "solver/contact/detachment.hpp"
#include "solver/damping/damping.hpp"
#include "solver/numeric/polynomial.hpp"

#include <cmath>
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

    /// q of a state u = sqrt(contact radius).
    [[nodiscard]] Real coordinate(const Real& u) const { return squared ? u * u : u; }
    /// u = sqrt(contact radius) of a coordinate q.
    [[nodiscard]] Real root_radius(const Real& q) const {
        using std::sqrt;
        return squared ? sqrt(q > Real(0) ? q : Real(0)) : q;
    }
};

/// How a damping law depends on u = sqrt(contact radius): eta(u) for the scaled coefficient 1.
template <class U>
[[nodiscard]] constexpr U damping_shape(DampingLaw law, const U& u) {
    switch (law) {
        case DampingLaw::constant:
            return U(1);
        case DampingLaw::contact_radius:
            return u * u;
        case DampingLaw::tsuji:
            return u;
    }
    return U(0);
}

/// The scaled coefficient eta(u) of a damping law.
template <class Real>
[[nodiscard]] Polynomial<Real> damping_polynomial(DampingLaw law, Real number) {
    return number * damping_shape(law, Polynomial<Real>::identity());
}

/// The equation of motion on one branch delta(u), F(u); touch, equilibrium and end remain to be set.
template <class Real>
[[nodiscard]] Motion<Real> branch_motion(const Polynomial<Real>& overlap, const Polynomial<Real>& force,
                                         const Polynomial<Real>& damping) {
    Motion<Real> motion;
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

/// Builds the equation of motion from the law's own lines.
/// @param adhesion, damping_number scaled coefficients [1]
template <template <class> class L, class Real>
[[nodiscard]] Motion<Real> make_motion(Real adhesion, DampingLaw damping_law, Real damping_number,
                                       Detachment detachment) {
    const L<Real> numeric{adhesion};
    const L<Polynomial<Real>> law{Polynomial<Real>(adhesion)};
    const auto u = Polynomial<Real>::identity();
    Motion<Real> motion =
        branch_motion(law.overlap(u), law.force(u), damping_polynomial<Real>(damping_law, damping_number));
    motion.touch = motion.coordinate(numeric.touch());
    motion.equilibrium = motion.coordinate(*numeric.detachment_point(Detachment::zero_force));
    const bool by_force = detachment == Detachment::zero_force && damping_number != Real(0);
    if (!by_force) motion.end = motion.coordinate(*numeric.detachment_point(detachment));
    return motion;
}

}  // namespace ashimpact
