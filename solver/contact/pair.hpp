// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "core/quantities/names.hpp"
#include "core/quantities/parameter.hpp"

namespace ashimpact {

/// What a contact law needs to know of the two bodies; for a sphere on a flat wall R* = r1 and m* = m1. A
/// template so that laws take the lanes of a vector register too.
template <class Real>
struct BasicContactPair {
    Real mass;              ///< effective mass m* [kg]
    Real effective_radius;  ///< R* [m], Eq. 6
    Real contact_modulus;   ///< E* [Pa], Eq. 7
    Real work_of_adhesion;  ///< w [J/m2], energy to separate unit area (not a surface energy)
    Real yield_pressure =
        Real(std::numeric_limits<double>::infinity());  ///< p_y [Pa]; infinite: never yields
    ParameterValues<Real> parameters{};                 ///< of laws that declare their own
};
using ContactPair = BasicContactPair<double>;

/// Hertz stiffness k = (4/3) E* sqrt(R*) of F = k delta^(3/2) [N/m^(3/2)]; Dong et al. 2013, Eq. 9.
template <class Real>
[[nodiscard]] Real hertz_stiffness(const BasicContactPair<Real>& pair) {
    using std::sqrt;
    return Real(4.0 / 3.0) * pair.contact_modulus * sqrt(pair.effective_radius);
}

/// Pull-off force of the JKR theory F_c = (3/2) pi w R* [N], as a magnitude.
[[nodiscard]] inline double jkr_pull_off_force(const ContactPair& pair) {
    return 1.5 * std::numbers::pi * pair.work_of_adhesion * pair.effective_radius;
}

/// Where a contact ends; part of the physics, so recorded with every result.
enum class Detachment {
    zero_overlap,     ///< the surfaces are back where they first touched: delta = 0
    zero_force,       ///< the total force, damping included, has fallen to zero
    pull_off,         ///< displacement-controlled break: least overlap, the fold of the JKR curve
    load_controlled,  ///< load-controlled break: greatest tension
};

/// Names as on the command line and in artifacts.
template <>
struct Names<Detachment> {
    static constexpr std::string_view kind = "detachment";
    static constexpr std::array<std::string_view, 4> all{"zero-overlap", "zero-force", "pull-off",
                                                         "load-controlled"};
};

}  // namespace ashimpact
