// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "solver/contact/detachment.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/branches/cohesive_branches.hpp"

namespace ashimpact {

/// A Maugis-Dugdale impact: the branches it moves on, where it begins and where it ends; units of Maugis,
/// mass 1.
///
/// The surfaces come into reach at delta = -h_0 and jump to the stable state of that overlap; the velocity
/// does not change, the energy of the jump is lost. With detachment zero_overlap the impact also begins at
/// zero overlap, on the stable branch, and leaves out what happens across the gap.
class CohesiveMotion {
  public:
    using Number = Extended;

    /// @param damping eta as a polynomial of sqrt(a)
    CohesiveMotion(const CohesiveZone& zone, const Polynomial<Extended>& damping, Detachment detachment,
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

    /// Before the turn, in contact: the equilibrium that an approach creeps up to, if it is so damped that it
    /// never turns. It stays below the line v = (eta/2) (delta_eq - delta) if dF/d(delta) <= eta^2/4 all the
    /// way, and the stiffness rises all the way. @param state its position is a coordinate of touching()
    [[nodiscard]] std::optional<RestPlace<Extended>> creeps_to(const MotionState<Extended>& state) const;
    /// After the turn, in contact: whether the energy no longer suffices to reach the end.
    [[nodiscard]] bool captured(const MotionState<Extended>& state) const {
        return state.velocity * state.velocity / 2 + touching_.potential(state.position) < potential_at_end();
    }

  private:
    CohesiveZone zone_;
    TouchingBranch touching_;
    GapBranch gap_;
    CohesiveState begin_;
    CohesiveState end_;
    Extended outside_ = 0;
};

/// Why the detachment is not admissible for this transition parameter, in words; none if it is.
[[nodiscard]] std::optional<std::string> cohesive_refusal(const CohesiveZone& zone, Detachment detachment);

/// The same for a contact, without other validation.
[[nodiscard]] std::optional<std::string> cohesive_refusal(const ContactPair& contact, Detachment detachment);

/// Velocity for which BasicScale has the units of Maugis [m/s]; w must be above 0.
[[nodiscard]] double maugis_velocity(const ContactPair& contact);

}  // namespace ashimpact
