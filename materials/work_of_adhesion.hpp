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

/// Roughness of the surfaces in contact; see roughness_reduction().
struct Roughness {
    double rms = 0;                    ///< root-mean-square height of both surfaces together [m]
    double closest_distance = 0.3e-9;  ///< H_0, distance of surfaces in contact [m]
};

/// Returns the factor by which roughness reduces the work of adhesion [1], by the modified Rumpf model of
/// Rabinovich et al. 2000 (J. Colloid Interface Sci. 232:10, after Rumpf 1990):
///
///     w_rough/w = 1/(1 + R*/(1.48 rms)) + 1/(1 + 1.48 rms/H_0)^2.
///
/// A hemispherical asperity of radius 1.48 rms separates sphere and wall. The first term is the van der
/// Waals force of the asperity on the sphere, the second that of the wall, which the asperity holds off. The
/// model gives the ratio of pull-off forces; it scales w here, since pull-off forces are proportional to w
/// R*. Validity: rms below about 20 nm and far below R*, one asperity under the contact, elastic deformation
/// small against the asperity (hard particles). 1 for rms = 0. A lower estimate: for wide asperities
/// Rabinovich et al. measured up to ten times more.
/// Errors: InputError for a negative rms or a radius or H_0 that is not positive.
[[nodiscard]] double roughness_reduction(double effective_radius, const Roughness& roughness);

}  // namespace ashimpact
