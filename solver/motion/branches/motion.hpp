// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <optional>

#include "solver/contact/pair.hpp"
#include "solver/damping/registry.hpp"
#include "solver/motion/branches/motion_state.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// One branch of a static law as polynomials of u = sqrt(contact radius), scaled.
template <class Real>
struct StaticBranch {
    Polynomial<Real> overlap;               ///< delta(u)
    StaticForces<Polynomial<Real>> forces;  ///< F(u) = F_r - |F_a|
};

/// A damping law with its scaled coefficients.
template <class Real>
struct ScaledDamping {
    using Forces = StaticForces<Polynomial<Real>>;

    std::function<Polynomial<Real>(const Forces&)> on_branch;  ///< eta(u), scaled [1]
    bool overdamped = false;  ///< captures every impact that touches at zero contact radius

    /// Damping law D.
    template <class D>
    [[nodiscard]] static ScaledDamping by(const DampingNumbers<Real>& numbers) {
        const auto eta = [numbers](const Forces& forces) {
            const auto shapes = D::shapes(Polynomial<Real>::identity(), forces);
            Polynomial<Real> sum = numbers[0] * shapes[0];
            for (std::size_t k = 1; k < shapes.size(); ++k) sum = sum + numbers[k] * shapes[k];
            return sum;
        };
        return {eta, numbers[0] * numbers[0] >= Real(D::overdamped_squared)};
    }
    /// A registered damping law.
    [[nodiscard]] static ScaledDamping of(DampingLaw law, const DampingNumbers<Real>& numbers) {
        return RegisteredDampings::visit<ScaledDamping>(law, [&]<class D>() { return by<D>(numbers); });
    }
    [[nodiscard]] static ScaledDamping none() { return of(DampingLaw::constant, {}); }
};

/// The equation of motion of one impact on one branch, scaled (mass 1, Hertz stiffness 1), in the regularised
/// coordinate q:
///
///     dq/dtheta = v,   dv/dtheta = -delta'(q) (eta(q) v + F(q)),   dt/dtheta = delta'(q),   v = d(delta)/dt.
///
/// q is u = sqrt(contact radius), or u^2 where every polynomial is even in u. Nothing is singular at touch,
/// turning point or detachment.
template <class Real>
struct Motion {
    using Number = Real;

    Polynomial<Real> overlap;    ///< delta(q)
    Polynomial<Real> slope;      ///< delta'(q)
    Polynomial<Real> force;      ///< F(q)
    Polynomial<Real> damping;    ///< eta(q)
    Polynomial<Real> stiffness;  ///< delta'(q) F(q) = dU/dq
    Polynomial<Real> drag;       ///< delta'(q) eta(q)
    Polynomial<Real> potential;  ///< U(q)
    PowerChain powers;           ///< those of q in slope, drag and stiffness
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
    [[nodiscard]] bool damped() const { return damping != Polynomial<Real>(); }
    [[nodiscard]] RestPlace<Real> rest() const {
        return {equilibrium, overlap(equilibrium), potential(equilibrium)};
    }
    /// The motion as Taylor series about a state; the only arithmetic is products of power series.
    [[nodiscard]] MotionExpansion<Real> expand(const MotionState<Real>& state) const;
};

extern template struct Motion<double>;
extern template struct Motion<long double>;

/// The equation of motion on a branch; touch, equilibrium and end remain to be set.
template <class Real>
[[nodiscard]] Motion<Real> branch_motion(const StaticBranch<Real>& branch, const ScaledDamping<Real>& eta) {
    const Polynomial<Real> damping = eta.on_branch(branch.forces);
    const Polynomial<Real> force = branch.forces.repulsion - branch.forces.attraction;
    Motion<Real> motion;
    motion.overdamped = eta.overdamped;
    motion.squared = branch.overlap.even() && force.even() && damping.even();
    const auto reduced = [&](const Polynomial<Real>& p) { return motion.squared ? p.of_square() : p; };
    motion.overlap = reduced(branch.overlap);
    motion.force = reduced(force);
    motion.damping = reduced(damping);
    motion.slope = motion.overlap.derivative();
    motion.stiffness = motion.slope * motion.force;
    motion.drag = motion.slope * motion.damping;
    motion.potential = motion.stiffness.antiderivative();
    for (const Polynomial<Real>* p : {&motion.slope, &motion.drag, &motion.stiffness})
        motion.powers.require(*p);
    return motion;
}

/// The equation of motion of law L, whose static law is one branch. @param adhesion adhesion number [1]
template <template <class> class L, class Real>
[[nodiscard]] Motion<Real> make_motion(Real adhesion, const ScaledDamping<Real>& damping,
                                       Detachment detachment) {
    const L<Real> numeric{adhesion};
    const L<Polynomial<Real>> law{Polynomial<Real>(adhesion)};
    const auto u = Polynomial<Real>::identity();
    Motion<Real> motion = branch_motion<Real>({law.overlap(u), {power<6>(u), law.attraction(u)}}, damping);
    motion.touch = motion.coordinate(numeric.touch());
    motion.equilibrium = motion.coordinate(*numeric.detachment_point(Detachment::zero_force));
    const bool by_force = detachment == Detachment::zero_force && motion.damped();
    if (!by_force) motion.end = motion.coordinate(*numeric.detachment_point(detachment));
    return motion;
}

}  // namespace ashimpact
