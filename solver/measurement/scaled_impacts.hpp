#pragma once

#include "solver/contact/detachment.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact {

/// The impacts of one law with constant damping, reduced to their two numbers: the logarithm x = ln(v/V_a) of
/// the velocity over the law's adhesion velocity (0 for Hertz, which has none), and the damping number
/// beta = eta m^(-3/5) k^(-2/5) v^(-1/5). Every material is one of these impacts.
class ScaledImpacts {
  public:
    /// @throws InputError for a detachment that the law does not admit, or that never captures
    ScaledImpacts(Law law, Detachment detachment);

    [[nodiscard]] Law law() const { return law_; }
    [[nodiscard]] Detachment detachment() const { return detachment_; }
    /// Whether the law attracts; without attraction x is without effect.
    [[nodiscard]] bool adhesive() const { return adhesion_velocity_ > 0.0; }

    /// Restitution [1].
    [[nodiscard]] double restitution(double damping_number, double x) const;
    /// Restitution without damping, the greatest there is [1].
    [[nodiscard]] double greatest_restitution(double x) const;
    /// x below which every impact is captured, damped or not; minus infinity where there is none.
    [[nodiscard]] double lowest() const { return lowest_; }
    /// Contact time in units of the scale's time L/v; the impact must rebound [1].
    [[nodiscard]] double contact_time(double damping_number, double x) const;

    /// Damping number that gives @p restitution back, found from a guess; the accuracy is @p tolerance.
    /// Restitution 0 gives the smallest damping that captures.
    struct Search {
        double guess;
        double width;
        double tolerance = 1e-10;
    };
    [[nodiscard]] double damping_number(double restitution, double x, const Search& search) const;

  private:
    [[nodiscard]] double velocity(double x) const;

    Law law_;
    Detachment detachment_;
    double adhesion_velocity_;
    double lowest_;
};

}  // namespace ashimpact
