// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Damping in proportion to the contact radius, eta = C a: viscoelastic spheres (Kuwabara & Kono 1987;
/// Brilliantov et al. 1996).
struct ContactRadiusDamping {
    static constexpr DampingLaw law = DampingLaw::contact_radius;
    static constexpr std::string_view summary = "grows with the contact radius: viscoelastic spheres";
    static constexpr Dimension dimension = Dimension::viscosity;
    static constexpr double overdamped_squared = std::numeric_limits<double>::infinity();
    static constexpr double error_weight = 1.0;

    /// Terms of eta at u = sqrt(contact radius), each for the scaled coefficient 1.
    template <class U>
    [[nodiscard]] static constexpr std::array<U, 1> shapes(const U& u, const StaticForces<U>& /*forces*/) {
        return {u * u};
    }
    /// Coefficients whose scaled value is 1 [Pa s].
    template <class Scale>
    [[nodiscard]] static auto units(const Scale& scale) {
        return std::array{scale.momentum() / (scale.length * scale.radius_length)};
    }
    /// Scaled coefficient of a Hertz impact with e = 1 - @p loss, within a few per cent [1].
    [[nodiscard]] static double hertz_number(double loss) { return 0.88 * -std::log1p(-loss); }
};

}  // namespace ashimpact
