// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "solver/contact/law.hpp"
#include "solver/contact/pair.hpp"
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

    Law law_;
    Detachment detachment_;
    double adhesion_velocity_;  ///< of the unit pair
    double lowest_ = -std::numeric_limits<double>::infinity();
    VelocityRange range_;
    ChebyshevSurface damping_;
    ChebyshevSurface time_;
    double accuracy_ = std::numeric_limits<double>::infinity();
};

/// Damping and its slopes at one (velocity, restitution).
struct DampingAt {
    double value;           ///< eta [kg/s]
    double by_restitution;  ///< d eta/de [kg/s], never positive
    double by_velocity;     ///< d eta/dv [kg/m], positive
};

/// Velocity and its slope at one (restitution, damping).
struct VelocityAt {
    double value;       ///< v [m/s]
    double by_damping;  ///< dv/d eta [m/kg], positive
};

/// Velocity, restitution and damping of one contact under one law with constant damping: each as a function
/// of the other two. A look-up in a map takes microseconds; map().accuracy() states its error. Meant for fits
/// and Monte Carlo; results to be published come from solve_impact(), damping_from_restitution() and
/// critical_velocity().
class ContactModel {
  public:
    /// @throws InputError for a contact that is not physical, or one whose law has a history (yield)
    ContactModel(std::shared_ptr<const RestitutionMap> map, const ContactPair& contact);

    /// Velocities within the map [m/s].
    [[nodiscard]] VelocityRange range() const;
    [[nodiscard]] const ContactPair& contact() const { return contact_; }
    [[nodiscard]] const RestitutionMap& map() const { return *map_; }
    [[nodiscard]] const std::shared_ptr<const RestitutionMap>& shared_map() const { return map_; }

    /// The damping that gives a restitution; for e = 0 the smallest damping that captures.
    /// @param velocity within range() [m/s] @param restitution within [0, greatest_restitution(velocity)]
    [[nodiscard]] DampingAt damping(double velocity, double restitution) const;
    /// Restitution without damping, the greatest that can be reached [1].
    [[nodiscard]] double greatest_restitution(double velocity) const;
    /// The velocity at which an impact with this damping has this restitution; none if outside range().
    /// @param damping > 0 [kg/s] @param guess start of the search, if one is known [m/s]
    [[nodiscard]] std::optional<VelocityAt> velocity(double restitution, double damping,
                                                     std::optional<double> guess = std::nullopt) const;
    /// The velocity up to which impacts are captured, solved by integration if it lies outside range(); none
    /// if there is no finite critical velocity, or the damping is not positive [m/s].
    [[nodiscard]] std::optional<double> critical_velocity_anywhere(double damping) const;
    /// Restitution of an impact, 0 for a capture [1]. @param velocity within range() [m/s]
    [[nodiscard]] double restitution(double velocity, double damping) const;
    /// Options of rebound_restitution().
    struct Search {
        double guess;      ///< restitution to start from [1]
        double tolerance;  ///< ends when the restitution changes by no more than this [1]
    };
    /// Restitution of an impact that rebounds, by Newton's method within a shrinking bracket [1].
    [[nodiscard]] double rebound_restitution(double velocity, double damping, const Search& search) const;
    /// Contact time of a rebound [s].
    [[nodiscard]] double contact_time(double velocity, double restitution) const;

  private:
    [[nodiscard]] double x_of(double velocity) const { return std::log(velocity / velocity_unit_); }

    std::shared_ptr<const RestitutionMap> map_;
    ContactPair contact_;
    double velocity_unit_;  ///< adhesion velocity; 1 for Hertz [m/s]
    double damping_unit_;   ///< m^(3/5) k^(2/5), unit of damping at 1 m/s [kg/s (s/m)^(1/5)]
};

/// A map of @p law, of Hertz if @p contact has no adhesion, for @p velocities [m/s]. @throws InputError
[[nodiscard]] std::shared_ptr<const RestitutionMap> make_restitution_map(Law law, Detachment detachment,
                                                                         const ContactPair& contact,
                                                                         VelocityRange velocities);

/// The model of one contact, with a map of its own.
[[nodiscard]] ContactModel make_contact_model(Law law, Detachment detachment, const ContactPair& contact,
                                              VelocityRange velocities);

}  // namespace ashimpact
