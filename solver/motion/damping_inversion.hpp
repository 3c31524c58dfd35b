// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/motion/impact.hpp"

namespace ashimpact {

/// An impact whose damping coefficient is asked for.
struct DampingProblem {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
    ContactPair contact;
    double velocity;     ///< v_in [m/s]
    double restitution;  ///< measured e_n, 0 <= e_n < 1 [1]
};

struct DampingInversion {
    Damping damping;              ///< the coefficient that gives the measured restitution back
    double greatest_restitution;  ///< that without damping: the upper end of the reachable range [1]
    ImpactResult impact;          ///< the impact with that damping
    int impacts;                  ///< impacts solved on the way
};

/// The damping coefficient that gives a measured restitution, adhesion included; Dong et al. 2013,
/// section 4.2. Restitution falls monotonically with damping, so the answer is unique; it is exact to the
/// spacing of floating-point numbers. Restitution 0 gives the smallest damping that captures.
/// @param near a coefficient next to the answer, which saves the search for it; the answer does not depend on
/// it
/// @throws InputError if no damping gives the restitution, naming the reachable range; ConvergenceError
[[nodiscard]] DampingInversion damping_from_restitution(const DampingProblem& problem,
                                                        std::optional<double> near = std::nullopt);

}  // namespace ashimpact
