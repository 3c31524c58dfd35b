// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/velocity_scales.hpp"

#include <cmath>
#include <numbers>

#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

double velocity_of_damping(const Damping& damping, const ContactPair& contact) {
    if (vanishes_at_touch(damping.law)) return 0.0;
    return std::pow(Scale::of(contact, 1.0).damping_number(damping), 5);
}

double velocity_of_adhesion(Law law, const ContactPair& contact) {
    return law.visit<double>([&]<template <class> class L>() {
        // The adhesion number falls with a power of length.
        const double at_one = L<double>::adhesion_number(contact, 1.0);
        if (at_one == 0.0) return 0.0;
        const double exponent = std::log2(L<double>::adhesion_number(contact, 0.5) / at_one);
        const double length = std::pow(at_one, 1.0 / exponent);
        return std::sqrt(hertz_stiffness(contact) * length * length * std::sqrt(length) / contact.mass);
    });
}

double yield_velocity(const ContactPair& contact) {
    const double contact_radius = std::numbers::pi * contact.effective_radius * contact.yield_pressure /
                                  (2.0 * contact.contact_modulus);
    const double overlap = contact_radius * contact_radius / contact.effective_radius;
    const double energy = 0.4 * hertz_stiffness(contact) * overlap * overlap * std::sqrt(overlap);
    return std::sqrt(2.0 * energy / contact.mass);
}

}  // namespace ashimpact
