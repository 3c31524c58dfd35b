// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/branches/plastic_motion.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// An impact that arrives at the end of contact with no velocity left, scaled.
struct CriticalImpact {
    Extended velocity = 0;                 ///< v_c
    Extended dissipated = 0;               ///< work of damping
    Extended plastic = 0;                  ///< work spent in yielding
    Extended break_energy = 0;             ///< U(end) - U(touch), cost of the break
    std::optional<Extended> contact_time;  ///< first touch to arrival at rest; none if infinite
    Extended maximum_overlap = 0;
};

/// The critical impacts of a contact by ascending greatest contact, or the verdict if there is none.
struct CriticalImpacts {
    CaptureVerdict verdict = CaptureVerdict::finite;
    bool certain = true;  ///< false: series of the orbit left the range of numbers, so that others may decide
    std::vector<CriticalImpact> impacts{};
};

/// Of an elastic contact: one impact, followed backward from the end. @throws ConvergenceError
template <class Real>
[[nodiscard]] CriticalImpacts critical_impacts(const Motion<Real>& motion);
extern template CriticalImpacts critical_impacts(const Motion<double>&);
extern template CriticalImpacts critical_impacts(const Motion<long double>&);

/// Of a contact with a cohesive zone; units of Maugis. It must end where it can come to rest: U(end) above
/// the potential of static equilibrium. @throws ConvergenceError
[[nodiscard]] CriticalImpacts critical_impacts(const CohesiveMotion& motion);

/// Of an elastic-plastic contact up to the overlap @p farthest (scaled). The rebound depends on the greatest
/// contact reached. So the first step is to find every greatest contact from which unloading arrives at the
/// end of contact at rest; there may be several, since rebound need not be monotone. The second step follows
/// the loading branches backward from there; where no velocity in reach of the steps leads there, the
/// velocity is infinite. @throws ConvergenceError
[[nodiscard]] CriticalImpacts critical_impacts(const PlasticMotion<Extended>& motion, Extended farthest);

}  // namespace ashimpact
