// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/damping/registry.hpp"

namespace ashimpact {

/// In place of a Form: a cohesive zone (batch::ZoneCurve), with any damping law of one term. The coordinate q
/// is u of the curve, in units of Maugis; all else is in units of the scale.
struct ZoneForm {
    static constexpr bool yields = false;
};

/// A damping law in a cohesive zone.
struct ZoneDamping {
    int power;            ///< of u in eta
    double error_weight;  ///< as the law's
    bool bounds_return;   ///< no return is faster than 1/beta

    explicit ZoneDamping(DampingLaw law) {
        RegisteredDampings::visit<void>(law, [&]<class Damping>() {
            power = static_cast<int>(
                std::lround(std::log2(Damping::shapes(2.0, StaticForces<double>{64.0, 0.0})[0])));
            error_weight = Damping::error_weight;
            bounds_return = requires(const DampingNumbers<double>& n) {
                Damping::fastest_return(n);
            };
        });
    }
};

}  // namespace ashimpact
