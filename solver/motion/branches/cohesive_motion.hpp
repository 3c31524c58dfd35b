// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/branches/motion.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// Why the detachment is not admissible for this transition parameter, in words; none if it is.
[[nodiscard]] std::optional<std::string> cohesive_refusal(const CohesiveZone& zone, Detachment detachment);

/// The same for a contact, without other validation.
[[nodiscard]] std::optional<std::string> cohesive_refusal(const ContactPair& contact, Detachment detachment);

/// Velocity for which BasicScale has the units of Maugis [m/s]; w must be above 0.
[[nodiscard]] double maugis_velocity(const ContactPair& contact);

/// The touching part of a Maugis-Dugdale impact (CohesiveZone) in the regularised form of Motion:
///
///     dq/dtheta = v,   dv/dtheta = -delta'(q) (eta(q) v + F(q)),   dt/dtheta = delta'(q),
///
/// with q the contact radius a, or sqrt(a) where the damping needs it. Units of Maugis, mass 1. The
/// attraction |F_a| = a^3 - F is no polynomial of q, so the damping is taken as p(q) + p_a(q) |F_a|.
class TouchingBranch {
  public:
    /// @param damping linear in the attraction
    TouchingBranch(const CohesiveZone& zone, const ScaledDamping<Extended>& damping, Precision precision);

    [[nodiscard]] Extended coordinate(const CohesiveState& state) const;
    [[nodiscard]] CohesiveState state(Extended q) const;
    [[nodiscard]] Extended overlap(Extended q) const { return zone_.overlap(state(q)); }
    [[nodiscard]] Extended slope(Extended q) const;  ///< d(delta)/dq
    [[nodiscard]] Extended force(Extended q) const { return zone_.force(state(q)); }
    [[nodiscard]] Extended potential(Extended q) const { return zone_.potential(state(q)); }
    [[nodiscard]] Extended damping(Extended q) const;

    /// As Motion::expand().
    [[nodiscard]] MotionExpansion<Extended> expand(const MotionState<Extended>& state, int sense = 1) const;

    /// d(delta)/dq, F and eta as power series of q - @p q.
    struct Statics {
        Series<Extended> slope;
        Series<Extended> force;
        Series<Extended> damping;
    };
    [[nodiscard]] Statics statics(Extended q) const;

  private:
    template <class Real, class Goal>
    class Terms;
    template <class Real>
    [[nodiscard]] MotionExpansion<Extended> expanded(const MotionState<Extended>& start, int sense) const;

    CohesiveZone zone_;
    bool rooted_;  ///< q = sqrt(a)
    bool follows_attraction_;
    Polynomial<Extended> damping_;         ///< p
    Polynomial<Extended> per_attraction_;  ///< p_a
    PowerChain powers_;                    ///< those of q in both
    Precision precision_;
};

/// The part of the impact in which the surfaces attract one another across a gap, without damping. q is the
/// radius c of the cohesive zone, in which everything is a polynomial.
struct GapBranch : Motion<Extended> {
    explicit GapBranch(const CohesiveZone& zone)
        : Motion(branch_motion<Extended>({zone.gap_overlap(), zone.gap_force(), {}},
                                         ScaledDamping<Extended>::none())) {}
};

/// A Maugis-Dugdale impact: the branches it moves on, where it begins and where it ends; units of Maugis,
/// mass 1.
///
/// The surfaces come into reach at delta = -h_0 and jump to the stable state of that overlap; the velocity
/// does not change, the energy of the jump is lost. With detachment zero_overlap the impact also begins at
/// zero overlap, on the stable branch, and leaves out what happens across the gap.
class CohesiveMotion {
  public:
    using Number = Extended;

    CohesiveMotion(const CohesiveZone& zone, const ScaledDamping<Extended>& damping, Detachment detachment,
                   Precision precision);

    [[nodiscard]] const CohesiveZone& zone() const { return zone_; }
    [[nodiscard]] const TouchingBranch& touching() const { return touching_; }
    [[nodiscard]] const GapBranch& gap() const { return gap_; }
    [[nodiscard]] const CohesiveState& begin() const { return begin_; }
    [[nodiscard]] const CohesiveState& end() const { return end_; }
    /// Potential outside of the contact, before it begins and after it has ended: 0, or that of the first
    /// state at zero overlap where it begins and ends there.
    [[nodiscard]] Extended potential_outside() const { return outside_; }
    [[nodiscard]] Extended potential_at_begin() const { return zone_.potential(begin_); }
    [[nodiscard]] Extended potential_at_end() const { return zone_.potential(end_); }
    /// Static equilibrium, on the touching branch.
    [[nodiscard]] RestPlace<Extended> rest() const;
    [[nodiscard]] Extended fastest_return() const { return fastest_return_; }  ///< as of ScaledDamping

    /// Before the turn, in contact: the equilibrium that an approach creeps up to, if it is so damped that it
    /// never turns. It stays below the line v = (eta/2) (delta_eq - delta) if dF/d(delta) <= eta^2/4 all the
    /// way, and the stiffness rises all the way. @param state its position is a coordinate of touching()
    [[nodiscard]] std::optional<RestPlace<Extended>> creeps_to(const MotionState<Extended>& state) const;
    /// After the turn, in contact: whether the energy no longer suffices to reach the end.
    [[nodiscard]] bool captured(const MotionState<Extended>& state) const;

  private:
    CohesiveZone zone_;
    TouchingBranch touching_;
    GapBranch gap_;
    CohesiveState begin_;
    CohesiveState end_;
    Extended outside_ = 0;
    Extended fastest_return_;
    bool too_slow_;  ///< no return is fast enough at equilibrium to reach the end
};

}  // namespace ashimpact
