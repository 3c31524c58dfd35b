// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "materials/modulus.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// Phases, fractions both ways and Young's modulus by every rule; Dong et al. 2013, Eq. 1.
[[nodiscard]] ModulusResult modulus_stage(const Case& data, StageRecord& record);

/// A porosity law with the porosity that an apparent density implies.
struct PorosityFromDensity {
    Porosity porosity;
    Finding finding;  ///< the porosity
};

/// Completes a porosity law with P = 1 - apparent/true [kg/m3]; the uncertainty is that of the apparent
/// density. Errors: InputError for an apparent density above the true one.
[[nodiscard]] PorosityFromDensity porosity_from_density(Porosity porosity, const Quantity& apparent,
                                                        double true_density);

/// Composition and modulus of one sample; name and diameter are left empty.
[[nodiscard]] SampleModulus sample_modulus(const Composition& composition, const ModulusEstimate& estimate,
                                           MixtureRule rule);

}  // namespace ashimpact
