// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include "solver/contact/law.hpp"
#include "solver/contact/pair.hpp"
#include "solver/surrogate/restitution_map.hpp"
#include "solver/surrogate/restitution_section.hpp"

namespace ashimpact {

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

/// A velocity with what look-ups of many contacts at it have in common.
struct SharedVelocity {
    double log;         ///< ln v [ln m/s]
    double fifth_root;  ///< v^(1/5)

    [[nodiscard]] static SharedVelocity of(double velocity) {
        return {std::log(velocity), std::pow(velocity, 0.2)};
    }
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
    /// damping().value alone, in less than half the time [kg/s].
    [[nodiscard]] double damping_coefficient(double velocity, double restitution) const;
    /// The same, from a section of this map.
    [[nodiscard]] double damping_coefficient(const SharedVelocity& velocity,
                                             const RestitutionSection& section) const {
        return damping_unit_ * velocity.fifth_root * section.number(velocity.log - log_velocity_unit_);
    }
    /// Restitution without damping, the greatest that can be reached [1].
    [[nodiscard]] double greatest_restitution(double velocity) const;
    /// The velocity at which an impact with this damping has this restitution; none if outside range().
    /// @param damping > 0 [kg/s] @param guess start of the search, if one is known [m/s]
    [[nodiscard]] std::optional<VelocityAt> velocity(double restitution, double damping,
                                                     std::optional<double> guess = std::nullopt) const;
    /// The same, from a section of this map.
    [[nodiscard]] std::optional<VelocityAt> velocity(const RestitutionSection& section, double damping,
                                                     std::optional<double> guess = std::nullopt) const;
    /// The velocity up to which impacts are captured, solved by integration if it lies outside range(); none
    /// if there is no finite critical velocity, or the damping is not positive [m/s]. @param guess [m/s]
    [[nodiscard]] std::optional<double> critical_velocity_anywhere(
        double damping, std::optional<double> guess = std::nullopt) const;
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

    /// ln(v/V_a), the coordinate of the map; ln v for Hertz.
    [[nodiscard]] double x_of(double velocity) const { return std::log(velocity / velocity_unit_); }

  private:
    /// @param number_at damping number of the restitution at x, a NumberAlongX
    template <class NumberAt>
    [[nodiscard]] std::optional<VelocityAt> found_velocity(double restitution, double damping,
                                                           std::optional<double> guess,
                                                           const NumberAt& number_at) const;

    std::shared_ptr<const RestitutionMap> map_;
    ContactPair contact_;
    double velocity_unit_;      ///< adhesion velocity; 1 for Hertz [m/s]
    double log_velocity_unit_;  ///< its logarithm
    double damping_unit_;       ///< m^(3/5) k^(2/5), unit of damping at 1 m/s [kg/s (s/m)^(1/5)]
};

/// A map of @p law, of Hertz if @p contact has no adhesion, for @p velocities [m/s]. @throws InputError
[[nodiscard]] std::shared_ptr<const RestitutionMap> make_restitution_map(Law law, Detachment detachment,
                                                                         const ContactPair& contact,
                                                                         VelocityRange velocities);

/// The model of one contact, with a map of its own.
[[nodiscard]] ContactModel make_contact_model(Law law, Detachment detachment, const ContactPair& contact,
                                              VelocityRange velocities);

}  // namespace ashimpact
