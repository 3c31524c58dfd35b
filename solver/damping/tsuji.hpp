// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Tsuji, Tanaka & Ishida 1992: eta = C sqrt(m k) delta^(1/4), which makes the restitution of a Hertz contact
/// independent of velocity. With adhesion a^2/R* takes the place of delta.
struct TsujiDamping {
    static constexpr DampingLaw law = DampingLaw::tsuji;
    static constexpr std::string_view summary = "makes the restitution of hertz the same at every velocity";
    static constexpr Dimension dimension = Dimension::fraction;
    static constexpr double overdamped_squared = 5.0;  ///< a Hertz contact has e = 0 from C = sqrt(5) on
    static constexpr double error_weight = 3.0;

    /// Terms of eta at u = sqrt(contact radius), each for the scaled coefficient 1.
    template <class U>
    [[nodiscard]] static constexpr std::array<U, 1> shapes(const U& u, const StaticForces<U>& /*forces*/) {
        return {u};
    }
    /// Coefficients whose scaled value is 1: sqrt(m k) L^(1/4) is the unit of damping itself [1].
    template <class Scale>
    [[nodiscard]] static auto units(const Scale& scale) {
        return std::array{decltype(scale.momentum())(1)};
    }
    /// Restitution of a Hertz impact that ends at zero overlap, for a scaled coefficient, exactly [1].
    [[nodiscard]] static double hertz_restitution(double number) {
        const double share = number / std::sqrt(overdamped_squared);
        if (share >= 1) return 0;
        return std::exp(-std::numbers::pi * share / std::sqrt((1 - share) * (1 + share)));
    }
    /// Scaled coefficient of a Hertz impact with e = 1 - @p loss, exactly [1].
    [[nodiscard]] static double hertz_number(double loss) {
        const double log_loss = -std::log1p(-loss);
        return std::sqrt(overdamped_squared) * log_loss / std::hypot(std::numbers::pi, log_loss);
    }
};

}  // namespace ashimpact
