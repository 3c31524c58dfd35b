#pragma once

#include "materials/base/units.hpp"
#include "solver/contact/pair.hpp"

#include <array>
#include <string_view>

namespace ashimpact {

/// How the damping force F_d = eta d(delta)/dt depends on the contact.
enum class DampingLaw {
    constant,        ///< eta = C; the paper's model (Dong et al. 2013, Eq. 2)
    contact_radius,  ///< eta = C a; viscoelastic spheres (Kuwabara & Kono 1987; Brilliantov et al. 1996)
    tsuji,           ///< eta = C sqrt(m k) delta^(1/4), in JKR sqrt(m k) (a^2/R*)^(1/4); Tsuji et al. 1992
};

/// A damping law and its coefficient C, never negative: [kg/s] constant, [Pa s] contact_radius, [1] tsuji.
struct Damping {
    DampingLaw law = DampingLaw::constant;
    double coefficient = 0.0;
};

struct DampingName {
    DampingLaw law;
    std::string_view name;
    std::string_view unit;  ///< of the coefficient
};

inline constexpr std::array<DampingName, 3> damping_names{{
    {DampingLaw::constant, "constant", "kg/s"},
    {DampingLaw::contact_radius, "contact-radius", "Pa s"},
    {DampingLaw::tsuji, "tsuji", "1"},
}};

/// Name as used on the command line and in artifacts.
[[nodiscard]] std::string_view name_of(DampingLaw law);
/// What the coefficient measures.
[[nodiscard]] Dimension dimension_of(DampingLaw law);
/// Unit of the coefficient.
[[nodiscard]] std::string_view unit_of(DampingLaw law);
/// The damping law of that name. @throws InputError naming the allowed ones
[[nodiscard]] DampingLaw damping_named(std::string_view name);

}  // namespace ashimpact
