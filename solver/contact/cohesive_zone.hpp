// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/numeric/number.hpp"
#include "solver/numeric/polynomial.hpp"

namespace ashimpact {

/// One state of a Maugis-Dugdale pair, in Maugis' units (see CohesiveZone).
struct CohesiveState {
    Extended angle = 0;            ///< theta = arccos(a/c); pi/2 where the surfaces do not touch [1]
    Extended sine = 0;             ///< sin(theta) [1]
    Extended cosine = 1;           ///< cos(theta), exactly 0 where the surfaces do not touch [1]
    Extended cohesive_radius = 0;  ///< c, edge of the cohesive zone [1]

    [[nodiscard]] bool touching() const { return cosine > 0; }
    /// a = c cos(theta) [1]
    [[nodiscard]] Extended contact_radius() const { return cohesive_radius * cosine; }
};

/// Maugis 1992 (J. Colloid Interface Sci. 150:243): elastic spheres that attract one another with the
/// constant stress sigma_0 (Dugdale) wherever their gap is below h_0 = w/sigma_0. Static law for one
/// transition parameter lambda = 2 sigma_0 (R/(pi w K^2))^(1/3), K = (4/3) E*.
///
/// Units of Maugis: radii (pi w R^2/K)^(1/3), overlap (pi^2 w^2 R/K^2)^(1/3), force pi w R; energy is force
/// times overlap. In them the Hertz stiffness is 1 and lambda is the only number left.
///
/// The contact branch is written in theta = arccos(a/c), in which Maugis' equations are entire functions:
///
///     P c^2 + Q c = 1,   P = (lambda/2) (sin(2 theta)/2 - theta cos 2 theta),
///                        Q = (4/3) lambda^2 (theta sin theta + cos theta - 1),
///     delta = a^2 - (4/3) lambda c sin theta,   F = a^3 - lambda c^2 (theta + sin theta cos theta),
///     U = F delta/3 + a^5/15 - c^2/3 - lambda c^4 (theta/12 + sin(2 theta)/18 + sin(4 theta)/144).
///
/// theta falls from pi/2 (a = 0) to 0 (a infinite). The gap branch (a = 0) has the coordinate c:
///
///     delta = c^2/2 - 8 lambda c/(3 pi) - h_0,   F = -(pi/2) lambda c^2,   h_0 = 2/(pi lambda).
///
/// U is 0 where the surfaces are out of each other's reach, delta <= -h_0. docs/laws/maugis-dugdale.md
/// derives it.
class CohesiveZone {
  public:
    /// @param lambda transition parameter > 0 [1]
    explicit CohesiveZone(Extended lambda);

    [[nodiscard]] Extended lambda() const { return lambda_; }
    /// Reach of the cohesion h_0 before contact [1].
    [[nodiscard]] Extended reach() const;

    /// The touching state with angle @p theta in (0, pi/2].
    [[nodiscard]] CohesiveState at_angle(Extended theta) const;
    /// The touching state of contact radius @p a >= 0 [1].
    [[nodiscard]] CohesiveState at_contact_radius(Extended a) const;
    /// The state without contact whose cohesive zone has radius @p c [1].
    [[nodiscard]] static CohesiveState in_gap(Extended c);
    /// The stable state at overlap @p delta, not below that of pull_off() [1].
    [[nodiscard]] CohesiveState at_overlap(Extended delta) const;

    [[nodiscard]] Extended overlap(const CohesiveState& state) const;
    [[nodiscard]] Extended force(const CohesiveState& state) const;
    [[nodiscard]] Extended potential(const CohesiveState& state) const;
    /// dF/d(delta) along the branch; rises with overlap all along the stable branch [1].
    [[nodiscard]] Extended stiffness(const CohesiveState& state) const;

    /// Gap branch as polynomials of c.
    [[nodiscard]] Polynomial<Extended> gap_overlap() const;
    [[nodiscard]] Polynomial<Extended> gap_force() const;

    /// Where gap and contact branch meet: a = 0.
    [[nodiscard]] CohesiveState join() const { return join_; }
    /// The stable state at delta = -h_0, into which the surfaces jump when they come within reach.
    [[nodiscard]] CohesiveState touch() const { return touch_; }
    /// The fold: least overlap of the stable branch.
    [[nodiscard]] CohesiveState pull_off() const { return pull_off_; }
    /// Greatest tension.
    [[nodiscard]] CohesiveState greatest_tension() const { return greatest_tension_; }
    /// Static equilibrium, F = 0.
    [[nodiscard]] CohesiveState equilibrium() const { return equilibrium_; }

    /// Work lost in both jumps of an undamped impact that ends at the fold, W = U(fold) - U(touch) >= 0 [1].
    [[nodiscard]] Extended separation_energy() const;

    /// Derivatives along the contact branch, for expansions in series.
    struct Slopes {
        Extended radius;           ///< -da/dtheta = T > 0
        Extended cohesive_radius;  ///< -dc/dtheta/cos(theta) = M
        Extended overlap;          ///< -d(delta)/dtheta/cos(theta) = g; positive where stable
        Extended force;            ///< -dF/dtheta/cos(theta); negative beyond the greatest tension
    };
    [[nodiscard]] Slopes slopes(const CohesiveState& state) const;
    /// P (quadratic) and Q (linear) at the angle of a state, without cancellation.
    [[nodiscard]] Extended quadratic(const CohesiveState& state) const;
    [[nodiscard]] Extended linear(const CohesiveState& state) const;

  private:
    template <class Function>
    [[nodiscard]] CohesiveState contact_where(Function&& function, Extended from) const;

    Extended lambda_;
    CohesiveState join_;
    CohesiveState pull_off_;
    CohesiveState touch_;
    CohesiveState greatest_tension_;
    CohesiveState equilibrium_;
};

}  // namespace ashimpact
