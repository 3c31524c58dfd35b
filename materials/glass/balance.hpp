// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/quantities/names.hpp"
#include "core/quantities/quantity.hpp"
#include "materials/composition.hpp"
#include "materials/glass/chemistry.hpp"
#include "materials/glass/properties.hpp"

namespace ashimpact {

/// Code of every finding on the chemistry of a glass.
inline constexpr std::string_view glass_code = "glass";

/// A chemical analysis of a whole sample, by weight.
struct OxideAnalysis {
    std::vector<OxideShare> oxides;                ///< as listed, each once
    std::optional<OxideShare> loss_on_ignition{};  ///< its name is "LOI"
    std::string source{};                          ///< in words; may be empty
    /// The text beside the table by which the oxides are those of the ignited sample; empty: there is none.
    std::string ignited{};
};

/// Standard uncertainties that are assumed where an analysis states none [1]: of an oxide and of a phase,
/// each at least the absolute one.
inline constexpr double assumed_oxide_uncertainty = 0.02;
inline constexpr double least_oxide_uncertainty = 0.001;
inline constexpr double assumed_phase_uncertainty = 0.05;
inline constexpr double least_phase_uncertainty = 0.005;

/// Remainders further below zero than this many of their standard uncertainties are errors.
inline constexpr double negative_remainder_limit = 3;

/// Density that is assumed for the glass of an ash [kg/m3], and its standard uncertainty: fly-ash glass lies
/// between those of silica, 2200, and of a calcium aluminosilicate, 2800.
inline constexpr double assumed_glass_density = 2500;
inline constexpr double assumed_glass_density_uncertainty = 100;

/// The glass of a sample by its chemistry.
struct ChemicalGlass {
    std::vector<OxideShare> oxides{};  ///< of the glass, by weight [1, sum 1]; those above zero
    Quantity weight_fraction{};        ///< of the oxides that are left, in the whole [1]
    Quantity amorphous_fraction{};     ///< as the XRD result has it [1]
    Quantity density{};                ///< [kg/m3]
    bool density_assumed = false;
    Quantity young_modulus{};      ///< by Makishima & Mackenzie [Pa]
    double poisson_ratio = 0;      ///< [1]
    std::vector<Finding> notes{};  ///< on the analysis and the balance
};

/// Amounts of the oxides by weight.
[[nodiscard]] OxideAmounts amounts_of(const std::vector<OxideShare>& oxides);

/// An analysis of the sample as it was measured by XRD, from one that may be of the ignited sample: its
/// oxides then add up to 100 % without the loss on ignition, and are multiplied by 1 - LOI. Errors:
/// InputError for oxides that are not in the table, listed twice, negative or above 100 %, and for a sum
/// outside of 90 % to 105 %.
[[nodiscard]] OxideAnalysis as_received(const OxideAnalysis& analysis, std::vector<Finding>& notes);

/// Finds the glass of a sample as the difference of its oxides and those of its crystalline phases, with
/// uncertainties propagated linearly from both, correlations included. The gap of the sum to 100 % counts as
/// a common relative error of all oxides with a rectangular distribution. Carbon dioxide, water and sulfur
/// trioxide that the analysis does not list are not balanced.
/// @param density of the glass [kg/m3], as stated; none: assumed
/// Errors: InputError for a phase without a formula, a sample without glass, an oxide of a phase that the
/// analysis does not list, and, naming the oxide, for a remainder below zero by more than three of its
/// standard uncertainties.
[[nodiscard]] ChemicalGlass glass_from_chemistry(const OxideAnalysis& analysis,
                                                 const Composition& composition,
                                                 const std::optional<Quantity>& density = {});

/// Glass whose modulus the amorphous part of a sample takes.
enum class GlassSource { catalogue, from_chemistry };

template <>
struct Names<GlassSource> {
    static constexpr std::string_view kind = "glass";
    static constexpr std::array<std::string_view, 2> all{"catalogue", "from-chemistry"};
};

/// What is known of the glass of a sample beside its XRD result.
struct GlassInputs {
    std::optional<OxideAnalysis> oxides{};
    GlassSource source = GlassSource::catalogue;
    std::optional<Quantity> density{};  ///< as stated [kg/m3]
};

/// A sample with its glass.
struct GlassInSample {
    Composition composition;               ///< with the glass that counts
    std::optional<ChemicalGlass> glass{};  ///< where there are oxides
    std::optional<Composition> other{};    ///< with the other glass, where there are oxides
};

/// Composes a sample as compose() does; where there are oxides, also with the glass that they give, whose
/// phase is called "glass-from-chemistry". Errors: as compose() and glass_from_chemistry(), and for a glass
/// from chemistry without oxides.
[[nodiscard]] GlassInSample compose_with_glass(const Analysis& analysis, const PhaseCatalogue& catalogue,
                                               const GlassInputs& inputs,
                                               const std::string& how_to_state = how_to_state_amorphous);

}  // namespace ashimpact
