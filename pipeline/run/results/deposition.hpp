// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// Units of what reaches a tube.
inline constexpr std::string_view mass_flux_unit = "kg/(m2 s)";
inline constexpr std::string_view mass_rate_unit = "kg/(m s)";
/// One kg/(m2 s) in g/(m2 h), as readers expect it; likewise of a length.
inline constexpr double grams_an_hour = 3.6e6;

/// The tube and the gas with its particles.
struct TubeConditions {
    double diameter = 0;     ///< of the tube [m]
    double velocity = 0;     ///< of the gas far upstream [m/s]
    double temperature = 0;  ///< of the gas [K]
    double density = 0;      ///< of the gas [kg/m3]
    double viscosity = 0;    ///< of the gas [Pa s]
    bool viscosity_given = false;
    std::optional<double> load{};  ///< mass of particles in the gas, at its temperature [kg/m3]
    std::string sizes{};           ///< the distribution, in words
};

/// What a number may be, by the intervals of v_c and by the assumptions on sizes.
struct DepositionSpan {
    double least = 0, greatest = 0;
};

/// A share with its span.
struct SpannedShare {
    double value = 0;  ///< [1]
    DepositionSpan span{};
};

/// Means of what rebounds; none: nothing does, or its restitution is not known.
struct ReboundMeans {
    std::optional<double> restitution{}, velocity{};  ///< [1]; normal, away from the wall [m/s]
};

/// What becomes of the particles of one class of sizes.
struct DepositedSize {
    double diameter = 0, from = 0, to = 0;  ///< [m]
    double mass_fraction = 0;               ///< of the load [1]
    double density = 0;                     ///< of the particles [kg/m3]
    double stokes = 0, effective_stokes = 0;
    double impaction_efficiency = 0;            ///< share of what flies at the tube that meets it [1]
    std::optional<double> critical_velocity{};  ///< none: all stay, or none do [m/s]
    std::optional<double> normal_velocity{};    ///< mean of arrivals [m/s]; none: nothing arrives
    SpannedShare stick_fraction{};              ///< of what arrives
    ReboundMeans rebound{};
    std::optional<Quantity> arrival_flux{},
        deposition_flux{};  ///< mean over the circumference; none: no load
};

/// What reaches a part of the circumference, on both sides of the tube together.
struct DepositedArc {
    double from = 0, to = 0;                               ///< from the front [rad]
    double arrives = 0, stays = 0;                         ///< shares of what flies at the tube [1]
    std::optional<double> normal_velocity{}, incidence{};  ///< means of arrivals [m/s], from the normal [rad]
    ReboundMeans rebound{};
    std::optional<Quantity> arrival_flux{}, deposition_flux{};  ///< of this part
};

/// What stays under one assumption on sizes.
struct AssumedDeposition {
    SizeBasis basis = SizeBasis::adhesion;
    SpannedShare stays{};                       ///< of what arrives; span: interval of v_c
    std::optional<Quantity> deposition_flux{};  ///< mean over the circumference
};

/// Share of the mass that arrives, of sizes that were measured, from which the data support the answer [1].
inline constexpr double enough_supported = 0.9;

/// Mass of all sizes together.
struct DepositionTotal {
    double impaction_efficiency = 0;  ///< share of what flies at the tube that meets it [1]
    SpannedShare stick_fraction{};    ///< of what arrives [1]
    ReboundMeans rebound{};
    double half_angle = 0;                  ///< from the front, within which half of what stays lies [rad]
    double supported_fraction = 0;          ///< of the mass that arrives, of sizes that were measured [1]
    std::optional<double> outside_model{};  ///< the same, of sizes whose v_c is outside the model; none: 0
    std::optional<Quantity> deposition_flux{}, least_flux{},
        greatest_flux{};                        ///< mean over the circumference
    std::optional<Quantity> deposition_rate{};  ///< per length of tube
};

/// Result of the command, deposit.json.
struct DepositionResult {
    TubeConditions tube{};
    Law law{};
    SizeBasis basis = SizeBasis::measured;  ///< the assumption where sizes were not measured
    std::optional<SizeRange> measured{};    ///< sizes with a measured v_c
    DepositionTotal total{};
    std::vector<DepositedSize> sizes{};
    std::vector<DepositedArc> angles{};
    std::vector<AssumedDeposition> assumptions{};
};

}  // namespace ashimpact
