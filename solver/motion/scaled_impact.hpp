// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>

#include "solver/contact/registry.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/maugis/cohesive_impact.hpp"
#include "solver/motion/motion.hpp"
#include "solver/motion/plastic_orbit.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/extended.hpp"

namespace ashimpact {

/// The scaled equation of motion of an impact that is not is_cohesive(). The scale sets the velocity; that of
/// the impact is not used. Law maugis-dugdale without adhesion is Hertz.
template <class Real>
[[nodiscard]] Motion<Real> scaled_motion(const Impact& impact, const Scale& scale) {
    return impact.law.visit<Motion<Real>>([&]<template <class> class L>() {
        const Real damping = scale.damping_number(impact.damping);
        if constexpr (has_polynomials<L>) {
            return make_motion<L, Real>(L<double>::adhesion_number(impact.contact, scale.length),
                                        impact.damping.law, damping, impact.detachment);
        } else {
            return make_motion<Hertz, Real>(Real(0), impact.damping.law, damping, Detachment::zero_overlap);
        }
    });
}

/// The scaled branches of an elastic-plastic impact; requires can_yield().
template <class Real>
[[nodiscard]] PlasticMotion<Real> scaled_plastic_motion(const Impact& impact, const Scale& scale) {
    return {{Real(ThorntonNing<double>::adhesion_number(impact.contact, scale.length)),
             Real(ThorntonNing<double>::yield_number(impact.contact, scale.length))},
            impact.damping.law,
            Real(scale.damping_number(impact.damping)),
            impact.detachment};
}

/// Follows an impact of any law in its own scale, unless it is_cohesive(); @p observe as in follow().
template <class Real, class Observer>
[[nodiscard]] Orbit<Real> scaled_orbit(const Impact& impact, const Scale& scale, Observer&& observe) {
    return can_yield(impact.law, impact.contact)
               ? follow_plastic(scaled_plastic_motion<Real>(impact, scale), Real(1), observe).orbit
               : follow(scaled_motion<Real>(impact, scale), Real(1), observe);
}

/// Restitution alone of an impact in its own scale, without validation [1].
template <class Real>
[[nodiscard]] Real scaled_restitution(const Impact& impact, const Scale& scale) {
    if (is_cohesive(impact.law, impact.contact)) {
        constexpr auto precision = std::is_same_v<Real, double> ? Precision::standard : Precision::extended;
        return static_cast<Real>(cohesive_restitution(impact, precision));
    }
    constexpr auto unobserved = [](const Motion<Real>&, const MotionExpansion<Real>&, Real) {};
    const Orbit<Real> orbit = scaled_orbit<Real>(impact, scale, unobserved);
    return orbit.outcome == Outcome::rebound ? std::abs(orbit.end.velocity) : Real(0);
}

}  // namespace ashimpact
