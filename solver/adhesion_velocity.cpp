#include "solver/adhesion_velocity.hpp"

#include "solver/scale.hpp"

#include <cmath>

namespace ashimpact {

double adhesion_velocity(Law law, const ContactPair& contact) {
    return law.visit<double>([&]<template <class> class L>() {
        // The adhesion number falls with a power of length.
        const double at_one = L<double>::adhesion_number(contact, 1.0);
        if (at_one == 0.0) return 0.0;
        const double exponent = std::log2(L<double>::adhesion_number(contact, 0.5) / at_one);
        const double length = std::pow(at_one, 1.0 / exponent);
        const Scale unit = Scale::of(contact, 1.0);
        return std::sqrt(unit.stiffness * length * length * std::sqrt(length) / unit.mass);
    });
}

}  // namespace ashimpact
