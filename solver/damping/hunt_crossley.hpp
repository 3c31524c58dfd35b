// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Damping in proportion to the Hertzian force, eta = zeta F_r with F_r = K a^3/R* (Hunt & Crossley 1975, J.
/// Appl. Mech. 42:440, the paper's reference [34]). It vanishes at touch: without adhesion every impact
/// rebounds.
struct HuntCrossleyDamping {
    static constexpr DampingLaw law = DampingLaw::hunt_crossley;
    static constexpr std::string_view summary = "grows with the repulsive force";
    static constexpr Dimension dimension = Dimension::inverse_velocity;
    static constexpr double overdamped_squared = std::numeric_limits<double>::infinity();
    static constexpr double error_weight = 3.0;  ///< with JKR, whose estimates can be too low

    /// Terms of eta, each for the scaled coefficient 1.
    template <class U>
    [[nodiscard]] static constexpr std::array<U, 1> shapes(const U& /*u*/, const StaticForces<U>& forces) {
        return {forces.repulsion};
    }
    /// Coefficients whose scaled value is 1 [s/m].
    template <class Scale>
    [[nodiscard]] static auto units(const Scale& scale) {
        return std::array{decltype(scale.momentum())(1) / scale.velocity};
    }
    /// Velocity that no return exceeds [1]: at 1/zeta the damping force balances the whole repulsion.
    template <class Real>
    [[nodiscard]] static Real fastest_return(const DampingNumbers<Real>& numbers) {
        return Real(1) / numbers[0];
    }
    /// Restitution of a Hertz impact that ends at zero overlap, exactly [1]: the root of
    /// z (1 + e) = ln[(1 + z)/(1 - z e)] for z = @p number. With s = z (1 + e) it reads s = (1 + z)(1 -
    /// exp(-s)).
    [[nodiscard]] static double hertz_restitution(double number) {
        using Precise = long double;  // s and z (1 + e) cancel for small z
        const Precise z = number;
        if (z < 1e-6L) return static_cast<double>(1 - z * (2 - z * (4.0L / 3)) / 3);
        Precise s = std::min(1 + z, 2 * z);  // not below the root, from where Newton's method falls to it
        for (Precise before = 2 * s; s < before;) {
            before = s;
            s -= (s + (1 + z) * std::expm1(-s)) / (1 - (1 + z) * std::exp(-s));
        }
        return static_cast<double>(z < 1 ? s / z - 1 : (1 - (1 + z) * std::exp(-s)) / z);
    }
    /// Scaled coefficient of a Hertz impact with e = 1 - @p loss, within 2 % [1].
    [[nodiscard]] static double hertz_number(double loss) {
        return loss * (1.5 - loss * loss * (0.11 + 0.39 * loss)) / (1 - loss);
    }
};

}  // namespace ashimpact
