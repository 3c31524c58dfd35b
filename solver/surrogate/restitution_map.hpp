// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/contact/detachment.hpp"
#include "solver/contact/law.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact {

/// A range of velocities [m/s], or of x = ln(v/V_a) [1].
struct VelocityRange {
    double lower;
    double upper;

    [[nodiscard]] bool contains(double x) const { return x >= lower && x <= upper; }
};

/// Damping number with its derivatives, at one (e, x).
struct DampingNumber {
    double value;           ///< beta = eta m^(-3/5) k^(-2/5) v^(-1/5) [1]
    double by_restitution;  ///< d beta/de
    double by_x;            ///< d beta/dx
};

/// The impacts of one law with constant damping. Scaled, an impact of any material depends on two numbers:
/// the logarithm x = ln(v/V_a) of the velocity over the law's adhesion velocity (without effect for Hertz,
/// which has none), and the damping number beta = eta m^(-3/5) k^(-2/5) v^(-1/5). The map is beta(e, x), the
/// damping number that gives a restitution. It takes a microsecond, where solving the impact takes
/// milliseconds.
///
/// beta is interpolated over the cube root of e/e_greatest. Near capture beta of an adhesive law expands in
/// powers of e^(1/3), which are whole powers of the cube root. Hertz has e and e^(3/2), the power 4.5 of the
/// cube root, which is smooth enough. The constructor compares the map with solved impacts, see accuracy().
class RestitutionMap {
  public:
    /// Solves the impacts, in some hundredths of a second. @param range of x, cut off where every impact is
    /// captured
    /// @throws InputError for a detachment that the law does not admit or that never captures, or an empty
    /// range
    RestitutionMap(Law law, Detachment detachment, VelocityRange range);

    [[nodiscard]] Law law() const { return law_; }
    [[nodiscard]] Detachment detachment() const { return detachment_; }
    /// Whether the law has adhesion; otherwise x has no effect.
    [[nodiscard]] bool adhesive() const { return adhesion_velocity_ > 0.0; }
    /// x below which every impact is captured, damped or not; minus infinity if there is none.
    [[nodiscard]] double lowest() const { return lowest_; }
    /// Velocity of a pair whose mass, radius, stiffness and work of adhesion are 1.
    [[nodiscard]] double unit_velocity(double x) const {
        return adhesive() ? adhesion_velocity_ * std::exp(x) : 1.0;
    }
    [[nodiscard]] VelocityRange range() const { return range_; }
    /// Largest error in restitution found when the map was checked [1].
    [[nodiscard]] double accuracy() const { return accuracy_; }

    /// @param restitution 0 <= e <= greatest_restitution(x); @param x within range()
    [[nodiscard]] DampingNumber damping_number(double restitution, double x) const;
    /// Restitution without damping, the greatest there is [1].
    [[nodiscard]] double greatest_restitution(double x) const {
        return std::sqrt(std::max(0.0, -std::expm1(2.0 * (lowest_ - x))));
    }
    /// Contact time in units of L/v, e > 0 [1].
    [[nodiscard]] double contact_time(double restitution, double x) const;

  private:
    [[nodiscard]] ChebyshevAxis axis_of_x() const;
    void tabulate_damping();
    void tabulate_times();
    void check();
    [[nodiscard]] double root_of_share(double restitution, double x) const {
        return std::cbrt(std::max(0.0, restitution) / greatest_restitution(x));
    }

    Law law_;
    Detachment detachment_;
    double adhesion_velocity_;  ///< of the unit pair
    double lowest_ = -std::numeric_limits<double>::infinity();
    VelocityRange range_;
    ChebyshevSurface damping_;
    ChebyshevSurface time_;
    double accuracy_ = std::numeric_limits<double>::infinity();
};

}  // namespace ashimpact
