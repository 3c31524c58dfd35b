#pragma once

#include "solver/impact.hpp"

#include <string>
#include <vector>

namespace ashimpact {

/// The numbers that say whether a contact law applies, and what they say of the law chosen.
struct Regime {
    double tabor_parameter;          ///< mu = (R* w^2/(E*^2 z0^3))^(1/3) [1]; Tabor 1977
    double damping_number;           ///< beta (constant damping) or its like for the other damping laws [1]
    double adhesion_number;          ///< of the law, in the impact's own scale [1]
    double yield_velocity;           ///< V_y; infinite without a yield pressure [m/s]
    double relative_contact_radius;  ///< greatest contact radius over R*, by sqrt(delta_max/R*) [1]
    std::vector<std::string> warnings;
};

/// Equilibrium separation z0 of two surfaces, as usual in the Tabor parameter [m].
inline constexpr double equilibrium_separation = 0.4e-9;

/// Tabor parameters between these belong to neither limit (Johnson & Greenwood 1997): DMT below, JKR above.
inline constexpr double dmt_limit = 0.1;
inline constexpr double jkr_limit = 5.0;

/// Judges an impact, solved or to be solved. @p maximum_overlap as in ImpactResult [m]
[[nodiscard]] Regime regime_of(const Impact& impact, double maximum_overlap);

}  // namespace ashimpact
