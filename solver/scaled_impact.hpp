#pragma once

#include "solver/impact.hpp"
#include "solver/motion.hpp"
#include "solver/scale.hpp"

namespace ashimpact {

/// The scalar solver's number type: its extra bits tell capture from rebound where the adhesive well is a
/// million times deeper than the kinetic energy.
using Extended = long double;

/// The scaled equation of motion of an impact (its velocity is not used: the scale sets it).
template <class Real>
[[nodiscard]] Motion<Real> scaled_motion(const Impact& impact, const Scale& scale) {
    return impact.law.visit<Motion<Real>>([&]<template <class> class L>() {
        return make_motion<L, Real>(L<double>::adhesion_number(impact.contact, scale.length),
                                    impact.damping.law, scale.damping_number(impact.damping),
                                    impact.detachment);
    });
}

}  // namespace ashimpact
