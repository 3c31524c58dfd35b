// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/contact/law.hpp"

namespace ashimpact {

/// A rebound at an angle; angles are from the normal [rad].
struct ObliqueRebound {
    double angle = 0;
    double restitution = 0;             ///< e of the normal velocity [1]
    double tangential_restitution = 0;  ///< e_t [1]
    double rebound_angle = 0;
};

/// Rebounds at one velocity of the sphere, from a small angle to that at which it is captured.
struct ObliqueCurve {
    double multiple = 0;       ///< velocity over v_c [1]
    double velocity = 0;       ///< [m/s]
    double captured_from = 0;  ///< the angle at which the normal velocity is v_c [rad]
    std::vector<ObliqueRebound> rebounds{};
};

/// What an angle changes for a sample, with the friction of the case.
struct ObliqueCurves {
    Law law;
    double friction = 0;  ///< mu [1]
    std::vector<ObliqueCurve> curves{};
};

}  // namespace ashimpact
