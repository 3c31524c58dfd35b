// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Constant damping, eta = C: the paper's model (Dong et al. 2013, Eq. 2).
struct ConstantDamping {
    static constexpr DampingLaw law = DampingLaw::constant;
    static constexpr std::string_view summary = "the same throughout the contact, as in the paper";
    static constexpr Dimension dimension = Dimension::damping;
    static constexpr double overdamped_squared = std::numeric_limits<double>::infinity();
    static constexpr double error_weight = 1.0;  ///< see docs/adding-a-law.md

    /// Terms of eta at u = sqrt(contact radius), each for the scaled coefficient 1.
    template <class U>
    [[nodiscard]] static constexpr std::array<U, 1> shapes(const U& /*u*/,
                                                           const StaticForces<U>& /*forces*/) {
        return {U(1)};
    }
    /// Coefficients whose scaled value is 1 [kg/s].
    template <class Scale>
    [[nodiscard]] static auto units(const Scale& scale) {
        return std::array{scale.momentum() / scale.length};
    }
    /// Scaled coefficient of a Hertz impact with e = 1 - @p loss, within a few per cent [1].
    [[nodiscard]] static double hertz_number(double loss) {
        return loss * (0.558 + 0.22 * loss + 0.33 * loss * loss * loss);
    }
};

}  // namespace ashimpact
