// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "solver/numeric/chebyshev.hpp"
#include "solver/surrogate/scaled_impacts.hpp"

namespace ashimpact {

/// Range of x = ln(v/V_a) that a map covers.
struct ScaledVelocityRange {
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

/// beta(e, x), the damping number that gives a restitution, for one law and all materials. It takes a
/// microsecond, where solving the impact takes milliseconds.
///
/// beta is interpolated over the cube root of e/e_greatest. Near capture beta of an adhesive law expands in
/// powers of e^(1/3), which are whole powers of the cube root. Hertz has e and e^(3/2), the power 4.5 of the
/// cube root, which is smooth enough. The constructor compares the map with solved impacts, see accuracy().
class RestitutionMap {
  public:
    /// Solves the impacts, in some hundredths of a second. The range is cut off where every impact is
    /// captured.
    /// @throws InputError for a detachment that does not capture or a range that is empty
    RestitutionMap(Law law, Detachment detachment, ScaledVelocityRange range);

    [[nodiscard]] const ScaledImpacts& impacts() const { return impacts_; }
    [[nodiscard]] ScaledVelocityRange range() const { return range_; }
    /// Largest error in restitution found when the map was checked [1].
    [[nodiscard]] double accuracy() const { return accuracy_; }

    /// @param restitution 0 <= e <= greatest_restitution(x); @param x within range()
    [[nodiscard]] DampingNumber damping_number(double restitution, double x) const;
    [[nodiscard]] double greatest_restitution(double x) const { return impacts_.greatest_restitution(x); }
    /// Contact time in units of L/v, e > 0 [1].
    [[nodiscard]] double contact_time(double restitution, double x) const;

  private:
    [[nodiscard]] ChebyshevAxis axis_of_x() const;
    void tabulate_damping();
    void tabulate_times();
    void check();
    [[nodiscard]] double root_of_share(double restitution, double x) const;

    ScaledImpacts impacts_;
    ScaledVelocityRange range_;
    ChebyshevSurface damping_;
    ChebyshevSurface time_;
    double accuracy_ = std::numeric_limits<double>::infinity();
};

}  // namespace ashimpact
