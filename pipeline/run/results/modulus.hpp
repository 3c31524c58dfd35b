// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "materials/modulus.hpp"

namespace ashimpact {

/// One phase of a sample.
struct PhaseShare {
    std::string name;                       ///< as the analysis has it
    std::string phase{};                    ///< of the catalogue
    double weight_fraction = 0;             ///< [1]
    double volume_fraction = 0;             ///< [1]
    std::optional<double> density{};        ///< [kg/m3]
    std::optional<double> young_modulus{};  ///< [Pa]
};

/// Bounds of Young's modulus that hold for any arrangement of the phases.
struct ModulusBounds {
    Quantity lower, upper;  ///< [Pa]
    std::optional<MixtureRule> lower_rule{}, upper_rule{};
};

/// Composition and Young's modulus of a sample.
struct SampleModulus {
    std::string name{};
    Quantity diameter{};  ///< [m]
    std::vector<PhaseShare> phases{};
    MixtureRule rule = MixtureRule::parallel;
    Quantity young_modulus{};  ///< by that rule, porosity applied [Pa]
    std::optional<ModulusBounds> bounds{};
    std::vector<RuleResult> rules{};            ///< of the dense mixture
    Quantity density{};                         ///< of the dense mixture [kg/m3]
    std::optional<double> poisson_ratio{};      ///< mixed from the phases [1]
    bool poisson_ratio_assumed = false;         ///< of one of the phases at least
    std::vector<Contribution> contributions{};  ///< to the variance of young_modulus, largest first
};

/// Result of the modulus stage, 1-modulus.json.
struct ModulusResult {
    std::vector<SampleModulus> samples{};
};

}  // namespace ashimpact
