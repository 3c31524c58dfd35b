// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

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

/// A damping number with its derivative along x at fixed restitution.
struct NumberAlongX {
    double value;
    double by_x;
};

/// The impacts of one law with constant damping. Scaled, an impact of any material depends on two numbers:
/// the logarithm x = ln(v/V_a) of the velocity over the law's adhesion velocity (without effect for Hertz,
/// which has none), and the damping number beta = eta m^(-3/5) k^(-2/5) v^(-1/5). The map is beta(e, x), the
/// damping number that gives a restitution. A look-up takes a microsecond, solving the impact milliseconds.
///
/// beta is interpolated over the cube root of e/e_greatest, because near capture beta of an adhesive law is a
/// series in e^(1/3). That of Hertz is one in e and e^(3/2), power 4.5 of the cube root, which is smooth
/// enough. The constructor compares the map with solved impacts, see accuracy().
class RestitutionMap {
  public:
    /// Solves the impacts, in some hundredths of a second. @param range of x; where every impact is captured
    /// it is cut off. @throws InputError for an empty range, or a detachment inadmissible or without captures
    RestitutionMap(Law law, Detachment detachment, VelocityRange range);

    [[nodiscard]] Law law() const { return law_; }
    [[nodiscard]] Detachment detachment() const { return detachment_; }
    /// Whether the law has adhesion; otherwise x has no effect.
    [[nodiscard]] bool adhesive() const { return adhesion_velocity_ > 0.0; }
    /// x of the undamped critical velocity, below which every impact is captured; minus infinity if none.
    [[nodiscard]] double lowest() const { return lowest_; }
    /// Velocity at @p x of the pair whose mass, radius, stiffness and work of adhesion are 1; 1 for Hertz.
    [[nodiscard]] double unit_velocity(double x) const;
    [[nodiscard]] VelocityRange range() const { return range_; }
    /// Largest error in restitution found when the map was checked [1].
    [[nodiscard]] double accuracy() const { return accuracy_; }

    /// @param restitution 0 <= e <= greatest_restitution(x); @param x within range()
    [[nodiscard]] DampingNumber damping_number(double restitution, double x) const;
    /// The same without the derivative by restitution; at restitution 0 it takes a tenth of the time.
    [[nodiscard]] NumberAlongX number_along_x(double restitution, double x) const;
    /// The damping number alone [1].
    [[nodiscard]] double number(double restitution, double x) const;
    /// Restitution without damping, sqrt(1 - (v_c/v)^2) with the undamped v_c [1].
    [[nodiscard]] double greatest_restitution(double x) const;
    /// Contact time in units of L/v, L = (m v^2/k)^(2/5) [1]. @param restitution > 0
    [[nodiscard]] double contact_time(double restitution, double x) const;

  private:
    [[nodiscard]] ChebyshevAxis axis_of_x() const;
    void tabulate_damping();
    void tabulate_times();
    void check();
    [[nodiscard]] double root_of_share(double restitution, double x) const;
    [[nodiscard]] double along_x(const SurfacePoint& at, double root, double x) const;

    Law law_;
    Detachment detachment_;
    double adhesion_velocity_;  ///< of the unit pair
    double lowest_ = -std::numeric_limits<double>::infinity();
    VelocityRange range_;
    ChebyshevSurface damping_;
    ChebyshevSurface capture_;  ///< damping_ at restitution 0
    ChebyshevSurface time_;
    double accuracy_ = std::numeric_limits<double>::infinity();
};

}  // namespace ashimpact
