// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/quantities/names.hpp"

namespace ashimpact {

/// How the work of adhesion w follows from the surface energies g1, g2 of the two bodies.
enum class AdhesionRule {
    girifalco_good,  ///< w = 2 sqrt(g1 g2)
    dong2013,        ///< w = sqrt(g1 g2), half of the above, as the paper prints it
    dupre,           ///< w = g1 + g2 - g12, needs the interfacial energy
};

template <>
struct Names<AdhesionRule> {
    static constexpr std::string_view kind = "adhesion rule";
    static constexpr std::array<std::string_view, 3> all{"girifalco-good", "dong2013", "dupre"};
};

/// Surface energies [J/m2]; an energy per surface, not the work of adhesion.
struct SurfaceEnergies {
    double particle = 0;
    double wall = 0;
    std::optional<double> interfacial{};  ///< g12, for the Dupre rule only
};

/// Returns the work of adhesion w [J/m2], the reversible work to part one unit of interface.
/// Source: Girifalco & Good 1957 (J. Phys. Chem. 61:904, interaction parameter 1); Dupre 1869 as in
/// Israelachvili 2011, section 17.1; Dong et al. 2013, text under Eq. 11, whose printed g1 + g2 + g12 is a
/// misprint and whose result w = sqrt(g1 g2) is half of what g12 = g1 + g2 - 2 sqrt(g1 g2) gives.
/// Errors: InputError for negative energies, for g12 missing (dupre) or given (others), for w below zero.
[[nodiscard]] double work_of_adhesion(AdhesionRule rule, const SurfaceEnergies& energies);

}  // namespace ashimpact
