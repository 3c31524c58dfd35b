// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "solver/contact/pair.hpp"
#include "solver/contact/static_branch.hpp"
#include "solver/damping/registry.hpp"
#include "solver/motion/branches/motion_state.hpp"
#include "solver/numeric/power_chain.hpp"
#include "solver/numeric/series.hpp"

namespace ashimpact {

/// A damping law with its scaled coefficients.
template <class Real>
struct ScaledDamping {
    using Forces = StaticForces<Polynomial<Real>>;

    std::function<Polynomial<Real>(const Forces&)> on_branch;  ///< eta(u), scaled [1]
    bool overdamped = false;  ///< captures every impact that touches at zero contact radius
    Real fastest_return = std::numeric_limits<Real>::infinity();  ///< velocity that no return exceeds

    /// Damping law D.
    template <class D>
    [[nodiscard]] static ScaledDamping by(const DampingNumbers<Real>& numbers) {
        const auto eta = [numbers](const Forces& forces) {
            const auto shapes = D::shapes(Polynomial<Real>::identity(), forces);
            Polynomial<Real> sum = numbers[0] * shapes[0];
            for (std::size_t k = 1; k < shapes.size(); ++k) sum = sum + numbers[k] * shapes[k];
            return sum;
        };
        ScaledDamping result{eta, numbers[0] * numbers[0] >= Real(D::overdamped_squared)};
        if constexpr (requires { D::fastest_return(numbers); })
            result.fastest_return = D::fastest_return(numbers);
        return result;
    }
    /// A registered damping law.
    [[nodiscard]] static ScaledDamping of(DampingLaw law, const DampingNumbers<Real>& numbers) {
        return RegisteredDampings::visit<ScaledDamping>(law, [&]<class D>() { return by<D>(numbers); });
    }
    [[nodiscard]] static ScaledDamping none() { return of(DampingLaw::constant, {}); }
};

/// The equation of motion along a piece of a branch, as polynomials of q.
template <class Real>
struct MotionPiece {
    Polynomial<Real> overlap;                            ///< delta(q)
    Polynomial<Real> slope;                              ///< delta'(q)
    Polynomial<Real> force;                              ///< F(q)
    Polynomial<Real> damping;                            ///< eta(q)
    Polynomial<Real> stiffness;                          ///< delta'(q) F(q) = dU/dq
    Polynomial<Real> drag;                               ///< delta'(q) eta(q)
    Polynomial<Real> potential;                          ///< U(q), continuous from piece to piece
    PowerChain powers;                                   ///< the powers of q in slope, drag and stiffness
    Real until = std::numeric_limits<Real>::infinity();  ///< q up to which it holds
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

    MotionPiece<Real> first;
    std::vector<MotionPiece<Real>> beyond{};  ///< the pieces after the first, by ascending q
    Real touch{};                             ///< q at first touch
    Real equilibrium{};                       ///< q of the static equilibrium, the minimum of U
    std::optional<Real> end{};  ///< q at which the contact ends; none if it ends at zero total force
    bool squared = false;       ///< q = u^2
    bool overdamped = false;    ///< the damping captures every impact that touches at zero contact radius
    Real fastest_return = std::numeric_limits<Real>::infinity();  ///< velocity that no return exceeds

    /// The piece on which @p q is; at a border the lower one.
    [[nodiscard]] const MotionPiece<Real>& at(const Real& q) const {
        if (beyond.empty() || q <= first.until) return first;
        return *std::ranges::find_if(beyond, [&](const auto& piece) { return q <= piece.until; });
    }
    [[nodiscard]] Real overlap(const Real& q) const { return at(q).overlap(q); }
    [[nodiscard]] Real slope(const Real& q) const { return at(q).slope(q); }
    [[nodiscard]] Real force(const Real& q) const { return at(q).force(q); }
    [[nodiscard]] Real damping(const Real& q) const { return at(q).damping(q); }
    [[nodiscard]] Real potential(const Real& q) const { return at(q).potential(q); }

    /// q of a state u = sqrt(contact radius).
    [[nodiscard]] Real coordinate(const Real& u) const { return squared ? u * u : u; }
    /// u = sqrt(contact radius) of a coordinate q.
    [[nodiscard]] Real root_radius(const Real& q) const {
        using std::sqrt;
        return squared ? sqrt(q > Real(0) ? q : Real(0)) : q;
    }
    [[nodiscard]] bool damped() const {
        const Polynomial<Real> none;
        return first.damping != none ||
               std::ranges::any_of(beyond, [&](const auto& piece) { return piece.damping != none; });
    }
    /// Whether no return turns the sign of the total force: without attraction, where the damping falls to
    /// touch with the repulsion or faster. The velocity at which they balance then never falls on the way
    /// out, and it is not reached.
    [[nodiscard]] bool force_keeps_sign() const {
        return equilibrium == Real(0) && first.damping.lowest() >= first.force.lowest();
    }
    [[nodiscard]] RestPlace<Real> rest() const {
        return {equilibrium, overlap(equilibrium), potential(equilibrium)};
    }
    /// Whether dF/d(delta) <= @p most everywhere between @p from and @p to.
    [[nodiscard]] bool is_soft(const Real& from, const Real& to, const Real& most) const;
    /// The motion as Taylor series about a state, by products of power series alone. The step ends where the
    /// motion leaves its piece. @param sense 1 forward in time, -1 backward
    [[nodiscard]] MotionExpansion<Real> expand(const MotionState<Real>& state, int sense = 1) const;
};

extern template struct Motion<double>;
extern template struct Motion<long double>;

/// The equation of motion on a branch of these pieces; the caller sets touch, equilibrium and end.
template <class Real>
[[nodiscard]] Motion<Real> branch_motion(std::span<const StaticBranch<Real>> pieces,
                                         const ScaledDamping<Real>& eta);
template <class Real>
[[nodiscard]] Motion<Real> branch_motion(const StaticBranch<Real>& branch, const ScaledDamping<Real>& eta) {
    return branch_motion<Real>(std::span(&branch, 1), eta);
}

/// The equation of motion of law L, whose static law is one branch. @param adhesion adhesion number [1]
template <template <class> class L, class Real>
[[nodiscard]] Motion<Real> make_motion(Real adhesion, const ScaledDamping<Real>& damping,
                                       Detachment detachment) {
    const L<Real> law{adhesion};
    const auto pieces = static_branches<L>(adhesion);
    Motion<Real> motion = branch_motion<Real>(std::span(pieces), damping);
    motion.touch = motion.coordinate(law.touch());
    motion.equilibrium = motion.coordinate(*law.detachment_point(Detachment::zero_force));
    const bool ends_by_force =
        detachment == Detachment::zero_force && motion.damped() && !motion.force_keeps_sign();
    if (!ends_by_force) motion.end = motion.coordinate(*law.detachment_point(detachment));
    return motion;
}

}  // namespace ashimpact
