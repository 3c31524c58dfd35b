// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/damping/damping.hpp"

namespace ashimpact {

/// A point of the damping against the incident velocity.
struct DampingNode {
    double velocity;     ///< v_in [m/s]
    double coefficient;  ///< [unit of the damping law]
};

/// The damping of every exported particle: coefficient(d, v_in) = c(v_in) (d/d_0)^n. c is piecewise linear
/// through the nodes and constant before the first and after the last. One node: no dependence on velocity.
/// n = 0 gives every size the same damping; n = 2 gives, with constant damping, Hertz spheres of one material
/// the same restitution at every size (m ~ d^3 and k ~ sqrt(d) in beta = eta/(m^(3/5) k^(2/5) v^(1/5))).
struct SizedDamping {
    DampingLaw law = DampingLaw::constant;
    std::vector<DampingNode> nodes{};  ///< at least one; velocities rise
    double reference_diameter = 0;     ///< d_0 [m]
    double exponent = 0;               ///< n [1]

    [[nodiscard]] bool depends_on_velocity() const { return nodes.size() > 1; }
    /// [unit of the damping law]
    [[nodiscard]] double coefficient(double diameter, double velocity) const;
    /// (d/d_0)^n [1]
    [[nodiscard]] double size_factor(double diameter) const;
    /// Whether there is no damping at any velocity.
    [[nodiscard]] bool is_zero() const;
};

}  // namespace ashimpact
