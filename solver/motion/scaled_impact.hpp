// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <variant>

#include "solver/contact/registry.hpp"
#include "solver/motion/follow.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// The damping of an impact in a scale.
template <class Real>
[[nodiscard]] ScaledDamping<Real> scaled_damping(const Impact& impact, const Scale& scale) {
    const auto numbers = scale.damping_numbers(impact.damping, impact.contact.parameters);
    DampingNumbers<Real> precise{};
    std::ranges::copy(numbers, precise.begin());
    return ScaledDamping<Real>::of(impact.damping.law, precise);
}

/// The scaled equation of motion of an elastic impact without a cohesive zone. The scale sets the velocity;
/// that of the impact is not used. Law maugis-dugdale without adhesion is Hertz.
template <class Real>
[[nodiscard]] Motion<Real> scaled_motion(const Impact& impact, const Scale& scale) {
    const auto damping = scaled_damping<Real>(impact, scale);
    return impact.law.visit<Motion<Real>>([&]<template <class> class L>() {
        if constexpr (has_polynomials<L>) {
            return make_motion<L, Real>(L<double>::adhesion_number(impact.contact, scale.length), damping,
                                        impact.detachment);
        } else {
            return make_motion<Hertz, Real>(Real(0), damping, Detachment::zero_overlap);
        }
    });
}

/// The branches of an impact with a cohesive zone, in units of Maugis.
/// @throws InputError for a transition parameter out of range
[[nodiscard]] CohesiveMotion scaled_cohesive_motion(const Impact& impact,
                                                    Precision precision = Precision::extended);

/// An impact of any law in scaled units, with the branches that its law has: one, those of a plastic history,
/// or those of a cohesive zone. Only here it is decided which.
template <class Real>
struct ScaledImpact {
    Scale scale;
    Extended velocity;  ///< of the impact, in units of scale.velocity [1]
    std::variant<Motion<Real>, PlasticMotion<Real>, CohesiveMotion> branches;
};

/// An impact in its own scale, whose unit of velocity is that of the impact; with a cohesive zone, in units
/// of Maugis. @param precision of a cohesive zone
template <class Real>
[[nodiscard]] ScaledImpact<Real> scaled_impact(const Impact& impact, Precision precision);

extern template ScaledImpact<double> scaled_impact(const Impact&, Precision);
extern template ScaledImpact<long double> scaled_impact(const Impact&, Precision);

/// Follows an impact on the branches of its law; @p observe and @p ringing as in follow() of a Motion.
template <class Observer = Unobserved>
Orbit<Extended> follow(const ScaledImpact<Extended>& impact, Observer&& observe = {},
                       std::size_t ringing = 0) {
    return std::visit(
        [&](const auto& branches) { return follow(branches, impact.velocity, observe, ringing); },
        impact.branches);
}

/// Restitution alone of an impact in its own scale, without validation [1].
template <class Real>
[[nodiscard]] Real scaled_restitution(const Impact& impact);

extern template double scaled_restitution(const Impact&);
extern template long double scaled_restitution(const Impact&);

/// Restitution of an impact without damping, without validation [1]: of one that cannot yield by the energy
/// that breaking its contact takes. @param impact its coefficient of damping is not used
[[nodiscard]] double undamped_restitution(Impact impact);

/// An impact followed to its end, without validation.
class FollowedImpact {
  public:
    /// @throws ConvergenceError at the step limit
    explicit FollowedImpact(const Impact& impact, Precision precision = Precision::extended);

    [[nodiscard]] Extended restitution() const { return orbit_.restitution(scaled_.velocity); }
    /// @param impact the same. @throws InputError beyond the plastic closure
    [[nodiscard]] ImpactResult result(const Impact& impact) const;

  private:
    ScaledImpact<Extended> scaled_;
    Orbit<Extended> orbit_;
};

}  // namespace ashimpact
