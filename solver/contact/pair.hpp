// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

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

}  // namespace ashimpact
