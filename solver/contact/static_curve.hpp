// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

/// One point of a static contact law, in SI units or normalised by Eq. 21.
struct StaticPoint {
    double contact_radius;    ///< a [m]
    double overlap;           ///< delta, positive in contact [m]
    double repulsive_force;   ///< F_r, never negative [N]
    double attractive_force;  ///< F_a, never positive [N]

    /// Total force F_tot = F_r + F_a, positive where it pushes the bodies apart [N].
    [[nodiscard]] double force() const { return repulsive_force + attractive_force; }
};

/// A contact law without dynamics: Dong et al. 2013, Eqs. 9-20 in SI units, Eqs. 21-27 (Figure 3) normalised.
/// The curve begins where the law detaches by default. That is zero overlap, or for JKR and maugis-dugdale
/// the fold, below which a contact is unstable; the fold of maugis-dugdale may lie across a gap, with contact
/// radius 0. A contact that can yield is refused, since its force depends on its history.
class StaticCurve {
  public:
    /// @param contact its mass is not used
    /// @throws InputError naming quantity, value, unit and what is allowed
    StaticCurve(Law law, const ContactPair& contact);

    /// The law in the units of Eq. 21: a/(pi w R*^2/K)^(1/3), F/(pi w R*), delta/(pi^2 w^2 R*/K^2)^(1/3) with
    /// K = (4/3) E*; no property of a particle is left in it.
    /// @throws InputError for a law with parameters of its own
    [[nodiscard]] static StaticCurve normalised(Law law);

    /// Overlap at which an impact begins [m]: 0, or where the surfaces of a cohesive zone come within reach,
    /// unless the contact ends at zero overlap.
    [[nodiscard]] double touch_overlap(Detachment detachment) const;
    /// Overlap at which the static contact ends; the law must have that point [m].
    [[nodiscard]] double end_overlap(Detachment detachment) const;

    /// The point where the curve begins.
    [[nodiscard]] StaticPoint first() const {
        return zone_ ? cohesive_point(zone_->pull_off()) : point(least_root_);
    }
    /// The point of contact radius @p a [m]. @throws InputError below the first point's
    [[nodiscard]] StaticPoint at_contact_radius(double a) const;
    /// The point of overlap @p delta [m]. @throws InputError below the first point's
    [[nodiscard]] StaticPoint at_overlap(double delta) const;
    /// @p count points evenly spaced in contact radius, from the first to overlap @p delta [m].
    /// @throws InputError for an overlap below the first point's or fewer than two points
    [[nodiscard]] std::vector<StaticPoint> sampled(double delta, int count) const;

  private:
    [[nodiscard]] StaticPoint point(double root) const;
    [[nodiscard]] StaticPoint cohesive_point(const CohesiveState& state) const;

    Law law_;
    double length_;                       ///< unit of overlap and contact radius, R* [m]
    double force_unit_;                   ///< [N]
    double adhesion_;                     ///< adhesion number of the law in these units [1]
    std::optional<CohesiveZone> zone_{};  ///< of law maugis-dugdale, which takes these two instead
    MaugisUnits units_{};
    double least_root_;  ///< sqrt(contact radius) where the curve begins, in these units [1]
};

}  // namespace ashimpact
