// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/modulus.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

/// The entry of a sample in 1-modulus.json, as later stages read it.
struct SampleModulus {
    std::string name;
    Quantity young_modulus;               ///< [Pa]
    std::optional<double> poisson_ratio;  ///< mixed from the phases [1]
    double density;                       ///< of the dense mixture [kg/m3]
};

/// Phases, fractions both ways and Young's modulus by every rule; Dong et al. 2013, Eq. 1.
[[nodiscard]] StageOutput modulus_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleModulus> read_moduli(const View& result);

/// A porosity law with the porosity that an apparent density implies.
struct PorosityFromDensity {
    Porosity porosity;
    std::string note;
};

/// Completes a porosity law with P = 1 - apparent/true [kg/m3]; the uncertainty is that of the apparent
/// density. Errors: InputError for an apparent density above the true one.
[[nodiscard]] PorosityFromDensity porosity_from_density(Porosity porosity, const Quantity& apparent,
                                                        double true_density);

/// Composition and modulus of one sample, with the keys of `ashimpact modulus --json`.
[[nodiscard]] Json modulus_json(const Composition& composition, const ModulusEstimate& estimate,
                                MixtureRule rule);

}  // namespace ashimpact
