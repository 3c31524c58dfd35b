// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "core/quantities/names.hpp"
#include "core/units/units.hpp"

namespace ashimpact {

/// How eta of the damping force F_d = eta d(delta)/dt depends on the contact. The type of each value is in
/// the list of registry.hpp, which compares the two.
enum class DampingLaw { constant, contact_radius, tsuji };

/// Names as on the command line and in artifacts.
template <>
struct Names<DampingLaw> {
    static constexpr std::string_view kind = "damping law";
    static constexpr std::array<std::string_view, 3> all{"constant", "contact-radius", "tsuji"};
};

/// A damping law and its coefficient C >= 0 [SI unit of the law's dimension].
struct Damping {
    DampingLaw law = DampingLaw::constant;
    double coefficient = 0.0;
};

/// What the coefficient measures.
[[nodiscard]] Dimension dimension_of(DampingLaw law);
/// SI unit of the coefficient.
[[nodiscard]] std::string_view unit_of(DampingLaw law);

/// Whether the damping vanishes with the contact radius. If it does not, every contact without adhesion that
/// ends at zero overlap has a critical velocity.
[[nodiscard]] bool vanishes_at_touch(DampingLaw law);
/// Square of the scaled coefficient from which on every impact that touches at zero contact radius is
/// captured; infinite if there is none [1].
[[nodiscard]] double overdamped_squared(DampingLaw law);
/// Whether a scaled coefficient reaches overdamped_squared().
template <class Real>
[[nodiscard]] bool is_overdamped(DampingLaw law, const Real& number) {
    return number * number >= Real(overdamped_squared(law));
}
/// Scaled coefficient of a Hertz impact with e = 1 - @p loss, approximately [1].
[[nodiscard]] double hertz_damping_number(DampingLaw law, double loss);

}  // namespace ashimpact
