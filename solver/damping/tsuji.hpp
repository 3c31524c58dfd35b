#pragma once

#include "materials/base/units.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

namespace ashimpact {

/// Tsuji, Tanaka & Ishida 1992: eta = C sqrt(m k) delta^(1/4), which makes the restitution of a Hertz contact
/// independent of velocity. With adhesion sqrt(m k) (a^2/R*)^(1/4).
struct TsujiDamping {
    static constexpr std::string_view name = "tsuji";
    static constexpr Dimension dimension = Dimension::fraction;
    static constexpr double overdamped_squared = 5.0;  ///< e of Hertz falls to 0 at C = sqrt(5), exactly
    static constexpr double error_weight = 3.0;

    /// eta at u = sqrt(contact radius) for the scaled coefficient 1.
    template <class U>
    [[nodiscard]] static constexpr U shape(const U& u) {
        return u;
    }
    /// The coefficient whose scaled value is 1: sqrt(m k) L^(1/4) is the unit of damping itself [1].
    template <class Scale>
    [[nodiscard]] static auto unit(const Scale& scale) {
        return decltype(scale.momentum())(1);
    }
    /// Scaled coefficient at which a Hertz impact loses @p loss = 1 - e, exactly [1].
    [[nodiscard]] static double hertz_number(double loss) {
        const double log_loss = -std::log1p(-loss);
        return std::sqrt(overdamped_squared) * log_loss / std::hypot(std::numbers::pi, log_loss);
    }
};

}  // namespace ashimpact
