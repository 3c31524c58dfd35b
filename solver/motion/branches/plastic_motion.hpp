// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "solver/contact/registry.hpp"
#include "solver/contact/thornton_ning.hpp"
#include "solver/motion/branches/motion.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// The branches of an elastic-plastic impact (ThorntonNing), scaled: elastic loading, plastic loading, and an
/// unloading curve for every greatest contact.
template <class Real>
class PlasticMotion {
  public:
    using Number = Real;

    PlasticMotion(const YieldedContact<Real>& contact, const ScaledDamping<Real>& damping,
                  Detachment detachment);

    [[nodiscard]] const Motion<Real>& elastic() const { return elastic_; }
    [[nodiscard]] const Motion<Real>& loading() const { return loading_; }
    /// Unloading from the state u_greatest of greatest contact, which must not be below yield().
    [[nodiscard]] Motion<Real> unloading(Real u_greatest) const;

    /// State u at which plastic loading starts: the yield point, or first touch if yields_at_touch().
    [[nodiscard]] Real yield() const { return std::max(yield_, elastic_touch()); }
    /// Whether the contact yields by adhesion alone, at first touch.
    [[nodiscard]] bool yields_at_touch() const { return yield_ < elastic_touch(); }
    /// Potential at a state u of the loading branch, continuous with the elastic one at yield. If adhesion
    /// alone makes the contact yield, it is continuous with that of the sphere flattened by the touch, so
    /// that plastic work counts from there.
    [[nodiscard]] Real loading_potential(Real u) const {
        return loading_.potential(loading_.coordinate(u)) + offset_;
    }
    /// Equilibrium of the loading branch.
    [[nodiscard]] RestPlace<Real> rest() const {
        const Real q = loading_.equilibrium;
        return {q, loading_.overlap(q), loading_potential(loading_.root_radius(q))};
    }
    /// Whether an approach on the elastic branch is so damped that it creeps through yield and on to rest().
    /// As CaptureTest::creeping_up(), over both branches: below the line v = (eta/2)(delta_eq - delta) it
    /// stays where dF/d(delta) <= eta^2/4 all the way.
    [[nodiscard]] bool creeps_through(const MotionState<Real>& state) const;
    /// Potential at first touch.
    [[nodiscard]] Real touch_potential() const {
        return yields_at_touch() ? loading_potential(yield()) : elastic_.potential(elastic_.touch);
    }

  private:
    [[nodiscard]] Real elastic_touch() const { return elastic_.root_radius(elastic_.touch); }
    [[nodiscard]] Motion<Real> loading_motion() const;

    PlasticLoading<Real> plastic_;
    ScaledDamping<Real> damping_;
    Detachment detachment_;
    Motion<Real> elastic_;
    Motion<Real> loading_;
    Real yield_{};
    Real offset_{};
};

/// CaptureTest of an approach that yields before equilibrium. Only one that creeps for ever is cut short; any
/// other is followed through its yield point.
template <class Real>
struct YieldingCreep {
    const PlasticMotion<Real>& motion;
    const int& steps;  ///< taken so far

    [[nodiscard]] std::optional<RestPlace<Real>> creeps_to(const MotionState<Real>& state) const {
        constexpr int many_steps = 1000;
        if (steps <= many_steps || !motion.creeps_through(state)) return std::nullopt;
        return motion.rest();
    }
};

template <class Real>
PlasticMotion<Real>::PlasticMotion(const YieldedContact<Real>& contact, const ScaledDamping<Real>& damping,
                                   Detachment detachment)
    : plastic_(contact.loading()),
      damping_(damping),
      detachment_(detachment),
      elastic_(make_motion<ThorntonNing, Real>(contact.adhesion, damping, detachment)),
      yield_(contact.yield_point()) {
    loading_ = loading_motion();
    const Motion<Real> start = yields_at_touch() ? unloading(yield()) : elastic_;
    offset_ = start.potential(start.coordinate(yield())) - loading_.potential(loading_.coordinate(yield()));
}

template <class Real>
Motion<Real> PlasticMotion<Real>::loading_motion() const {
    const auto u = Polynomial<Real>::identity();
    Motion<Real> motion =
        branch_motion<Real>({plastic_.overlap(u), {plastic_.repulsion(u), plastic_.attraction(u)}}, damping_);
    motion.touch = motion.coordinate(yield());
    // Without force beyond yield; 0 where the branch is repulsive throughout.
    const auto force = [&](Real x) { return plastic_.force(x); };
    motion.equilibrium =
        motion.coordinate(force(yield()) >= Real(0) ? Real(0) : root_beyond<Real>(force, yield(), yield()));
    return motion;
}

template <class Real>
Motion<Real> PlasticMotion<Real>::unloading(Real u_greatest) const {
    const auto u = Polynomial<Real>::identity();
    const Real flattening = plastic_.flattening(u_greatest);
    const Real adhesion = plastic_.adhesion;
    Motion<Real> motion = branch_motion<Real>(
        {flattening * power<4>(u) - adhesion * u +
             Polynomial<Real>(power<4>(u_greatest) * (Real(1) - flattening)),  // permanent overlap
         {flattening * power<6>(u), plastic_.attraction(u)}},
        damping_);
    const ThorntonNing<Real> flattened{adhesion /
                                       flattening};  // same points in u, in units of the flattened sphere
    motion.touch = Real(0);
    motion.equilibrium = motion.coordinate(*flattened.detachment_point(Detachment::zero_force));
    motion.end = motion.coordinate(*flattened.detachment_point(detachment_));
    return motion;
}

template <class Real>
bool PlasticMotion<Real>::creeps_through(const MotionState<Real>& state) const {
    if (loading_.equilibrium <= loading_.touch) return false;
    const Real damping = elastic_.damping(state.position);
    const Real way = loading_.overlap(loading_.equilibrium) - elastic_.overlap(state.position);
    if (!(state.velocity <= damping / Real(2) * way)) return false;
    const Real most = damping * damping / Real(4);
    return elastic_.is_soft(state.position, elastic_.coordinate(yield()), most) &&
           loading_.is_soft(loading_.touch, loading_.equilibrium, most);
}

}  // namespace ashimpact
