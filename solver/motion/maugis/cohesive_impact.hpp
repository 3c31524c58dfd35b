// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/impact.hpp"
#include "solver/motion/maugis/cohesive_orbit.hpp"

namespace ashimpact {

/// An impact that is_cohesive() in units of Maugis.
struct ScaledCohesiveImpact {
    Scale scale;  ///< scale.velocity is the unit of velocity, not the velocity of the impact
    CohesiveMotion motion;
    Extended velocity;  ///< of the impact, in that unit [1]
};

/// The impact in units of Maugis. @throws InputError for a transition parameter out of range
[[nodiscard]] ScaledCohesiveImpact scaled_cohesive_impact(const Impact& impact,
                                                          Precision precision = Precision::extended);

/// solve_impact(), restitution_of() and refusal() of an impact that is_cohesive(), without other validation.
[[nodiscard]] ImpactResult solve_cohesive_impact(const Impact& impact,
                                                 Precision precision = Precision::extended);
[[nodiscard]] Extended cohesive_restitution(const Impact& impact, Precision precision = Precision::extended);
[[nodiscard]] std::optional<std::string> cohesive_refusal(const ContactPair& contact, Detachment detachment);

}  // namespace ashimpact
