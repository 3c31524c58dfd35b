#include "pipeline/case/laws.hpp"

#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

bool is_adhesive(Law law) {
    constexpr ContactPair unit{.mass = 1, .effective_radius = 1, .contact_modulus = 1, .work_of_adhesion = 1};
    return law.visit<bool>(
        [&]<template <class> class L>() { return L<double>::adhesion_number(unit, 1.0) != 0; });
}

bool yields(Law law) {
    return can_yield(
        law,
        {.mass = 1, .effective_radius = 1, .contact_modulus = 1, .work_of_adhesion = 1, .yield_pressure = 1});
}

}  // namespace ashimpact
