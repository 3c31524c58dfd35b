// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "materials/composition.hpp"
#include "materials/modulus.hpp"
#include "solver/contact/pair.hpp"
#include "solver/statistics/propagation.hpp"

namespace ashimpact {

/// A contact whose properties follow from uncertain inputs.
struct RandomContact {
    std::vector<RandomInput> inputs;
    std::function<ContactPair(std::span<const double> values)> contact;  ///< for values of the inputs

    /// The contact at the values of the inputs.
    [[nodiscard]] ContactPair nominal() const;
};

/// The phases that a particle's Young's modulus follows from.
struct PhaseMixture {
    Composition composition;
    ModulusOptions options{};
};

/// A second sphere in place of the wall.
struct RandomPartner {
    RandomInput diameter;  ///< [m]
    RandomInput mass;      ///< [kg]
};

/// A sphere of one sieve size on a flat wall, or on a second sphere. Exactly one of mixture, young_modulus
/// and contact_modulus is given.
struct SphereInContact {
    RandomInput diameter;                                             ///< [m]
    RandomInput density;                                              ///< of the particle [kg/m3]
    RandomInput work_of_adhesion;                                     ///< [J/m2]
    RandomInput poisson_ratio{};                                      ///< of the particle [1]
    RandomInput wall_young_modulus{};                                 ///< [Pa]
    RandomInput wall_poisson_ratio{};                                 ///< [1]
    std::optional<PhaseMixture> mixture{};                            ///< XRD fractions and phase moduli, or
    std::optional<RandomInput> young_modulus{};                       ///< of the particle [Pa], or
    std::optional<RandomInput> contact_modulus{};                     ///< E* itself [Pa]
    std::optional<RandomPartner> partner{};                           ///< none: a flat wall
    double yield_pressure = std::numeric_limits<double>::infinity();  ///< [Pa]
    std::vector<std::pair<LawParameter, RandomInput>> parameters{};   ///< of laws that declare their own [SI]
    ParameterValues<double> other_parameters{};                       ///< that are no inputs [SI]
};

/// The inputs of a sphere in contact: first its diameter, density, w, and what its contact modulus comes
/// from, then its partner's; of a mixture, every fraction and every phase modulus whose uncertainty is known.
/// Fractions below zero count as zero.
/// @throws InputError unless exactly one way to a modulus is given
[[nodiscard]] RandomContact random_contact(const SphereInContact& sphere);

}  // namespace ashimpact
