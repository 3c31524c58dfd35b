// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solver/contact/pair.hpp"

namespace ashimpact {

/// Place of a velocity above the critical one, t = asinh(sqrt(v/v_c - 1)), 0 up to v_c [1]. Restitution and
/// measured damping are smooth in t, though as functions of v they begin with a vertical tangent at v_c.
[[nodiscard]] double place_above(double velocity, double critical);

/// The inverse, v = v_c (1 + sinh^2 t) [m/s].
[[nodiscard]] double velocity_at_place(double t, double critical);

/// A point of the damping against the incident velocity.
struct DampingNode {
    double t;            ///< place of the velocity above v_c, see place_above() [1]
    double coefficient;  ///< [unit of the damping law]
};

/// Damping of one size: linear in t^2 between its nodes, constant beyond the last one. So it leaves the
/// critical damping as v - v_c, and e rises from v_c as t does; linear in t, it would rise as the root of t.
/// One node: it does not depend on the velocity.
struct DampingCurve {
    std::vector<DampingNode> nodes{{0, 0}};  ///< at least one, the first at t = 0: the critical damping

    [[nodiscard]] bool depends_on_velocity() const { return nodes.size() > 1; }
    [[nodiscard]] double critical() const { return nodes.front().coefficient; }  ///< [unit of the law]
    [[nodiscard]] double operator()(double t) const;                             ///< [unit of the law]
    [[nodiscard]] bool is_zero() const;  ///< no damping at any velocity
};

/// A size of the ash with its contact and damping.
struct AshSize {
    double diameter;  ///< [m]
    ContactPair contact;
    double density;  ///< [kg/m3]
    DampingCurve damping{};
};

/// Ash of any diameter, by the sizes around it. Between two sizes the density, E*, w and the parameters of
/// the law are linear in ln d, and so is the logarithm of the damping at equal t. Beyond the first and the
/// last size they are those of that size, and the damping goes with (d/that size)^exponent.
struct AshBetween {
    const AshSize* lower;
    const AshSize* upper;
    double share;   ///< of the way from the lower size to the upper one in ln d; 0: the lower one alone [1]
    double factor;  ///< of the damping [1]

    [[nodiscard]] double density() const;          ///< [kg/m3]
    [[nodiscard]] double damping(double t) const;  ///< [unit of the damping law]
    /// Contact of the nearest sizes, with the mass and radius of theirs.
    [[nodiscard]] ContactPair materials() const;
};

/// Number of the piece of the sizes that holds a diameter: 0 below the first size, i between the sizes i-1
/// and i, the number of sizes above the last one. The formulas are smooth within a piece. One size: one
/// piece, 0.
[[nodiscard]] std::size_t piece_of(const std::vector<AshSize>& sizes, double diameter);

/// The ash of a diameter by the formulas of a piece, which may be continued beyond its ends.
[[nodiscard]] AshBetween ash_between(const std::vector<AshSize>& sizes, double exponent, double diameter,
                                     std::size_t piece);

}  // namespace ashimpact
