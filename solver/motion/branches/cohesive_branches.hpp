// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/contact/cohesive_zone.hpp"
#include "solver/motion/branches/motion.hpp"
#include "solver/numeric/extended.hpp"

namespace ashimpact {

/// The touching part of a Maugis-Dugdale impact (CohesiveZone) in the regularised form of Motion:
///
///     dq/dtheta = v,   dv/dtheta = -delta'(q) (eta(q) v + F(q)),   dt/dtheta = delta'(q),
///
/// with q the contact radius a, or sqrt(a) where the damping needs it. Units of Maugis, mass 1.
class TouchingBranch {
  public:
    /// @param damping eta as a polynomial of sqrt(a)
    TouchingBranch(const CohesiveZone& zone, const Polynomial<Extended>& damping, Precision precision);

    [[nodiscard]] Extended coordinate(const CohesiveState& state) const;
    [[nodiscard]] CohesiveState state(Extended q) const;
    [[nodiscard]] Extended overlap(Extended q) const { return zone_.overlap(state(q)); }
    [[nodiscard]] Extended slope(Extended q) const;  ///< d(delta)/dq
    [[nodiscard]] Extended force(Extended q) const { return zone_.force(state(q)); }
    [[nodiscard]] Extended potential(Extended q) const { return zone_.potential(state(q)); }
    [[nodiscard]] Extended damping(Extended q) const { return damping_(q); }

    /// The motion as Taylor series about a state; MotionExpansion::step as in MotionStepper.
    [[nodiscard]] MotionExpansion<Extended> expand(const MotionState<Extended>& state) const;

    /// d(delta)/dq, F and eta as power series of q - @p q.
    struct Statics {
        Series<Extended> slope;
        Series<Extended> force;
        Series<Extended> damping;
    };
    [[nodiscard]] Statics statics(Extended q) const;

  private:
    template <class Real>
    [[nodiscard]] MotionExpansion<Extended> expanded(const MotionState<Extended>& start) const;

    CohesiveZone zone_;
    bool rooted_;  ///< q = sqrt(a)
    Polynomial<Extended> damping_;
    PowerChain powers_;  ///< those of q in damping_
    Precision precision_;
};

/// The part of the impact in which the surfaces attract one another across a gap, without damping. q is the
/// radius c of the cohesive zone, in which everything is a polynomial.
struct GapBranch : Motion<Extended> {
    explicit GapBranch(const CohesiveZone& zone)
        : Motion(branch_motion<Extended>({zone.gap_overlap(), zone.gap_force(), {}},
                                         ScaledDamping<Extended>::none())) {}
};

}  // namespace ashimpact
