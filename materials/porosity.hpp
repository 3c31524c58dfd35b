// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/quantities/names.hpp"

namespace ashimpact {

/// Laws for Young's modulus of a porous solid, E = E0 f(P). None is the default: a law is chosen by name.
enum class PorosityLaw {
    hashin_shtrikman,  ///< upper bound of (K, G) with pores as a phase of K = G = 0
    coble_kingery,     ///< f = 1 - 1.9 P + 0.9 P^2
    pabst_gregorova,   ///< f = exp(-2 P/(1 - P))
    spriggs,           ///< f = exp(-b P), b from the user
    gibson_ashby,      ///< f = (1 - P)^2
};

template <>
struct Names<PorosityLaw> {
    static constexpr std::string_view kind = "porosity law";
    static constexpr std::array<std::string_view, 5> all{"hashin-shtrikman", "coble-kingery",
                                                         "pabst-gregorova", "spriggs", "gibson-ashby"};
};

/// A chosen law with the porosity P.
struct Porosity {
    PorosityLaw law = PorosityLaw::hashin_shtrikman;
    double value = 0;                              ///< P [1], volume of the pores over the whole, 0 <= P < 1
    std::optional<double> standard_uncertainty{};  ///< [1]
    std::optional<double> coefficient{};           ///< b of spriggs [1]
};

/// Young's modulus and Poisson's ratio of a solid, dense or porous.
struct PorousModuli {
    double young_modulus = 0;               ///< [Pa]
    std::optional<double> poisson_ratio{};  ///< [1]
};

/// Returns the moduli of a solid with pores. Sources and validity:
///   hashin-shtrikman  Hashin & Shtrikman 1963, J. Mech. Phys. Solids 11:127. An upper bound for isotropic
///                     porous solids, met by hollow-sphere assemblages (cenospheres) in K; needs Poisson's
///                     ratio, changes it.
///   coble-kingery     Coble & Kingery 1956, J. Am. Ceram. Soc. 39:377: closed spherical pores, nu0 near 0.3,
///                     measured up to P = 0.5.
///   pabst-gregorova   Pabst & Gregorova 2004, J. Mater. Sci. 39:3213: closed isometric pores.
///   spriggs           Spriggs 1961, J. Am. Ceram. Soc. 44:628: where b was fitted; does not vanish at P = 1.
///   gibson-ashby      Gibson & Ashby 1997, Cellular Solids: open cells, P above 0.7.
/// All but the first leave Poisson's ratio as it is. P is not checked here (see require_valid), so that
/// central differences work at P = 0. Errors: InputError for hashin-shtrikman without Poisson's ratio.
[[nodiscard]] PorousModuli porous_moduli(const PorousModuli& dense, const Porosity& porosity);

/// Throws InputError for P outside [0, 1) and for a coefficient that is missing or superfluous.
void require_valid(const Porosity& porosity);

/// Returns a warning if the law is used outside of its validity, else an empty text.
[[nodiscard]] std::string porosity_warning(const Porosity& porosity);

/// Returns the porosity [1] from the apparent (mercury, helium with closed pores) and the true density
/// [kg/m3]: P = 1 - apparent/true. Errors: InputError if the apparent density is the larger one.
[[nodiscard]] double porosity_from_densities(double apparent_density, double true_density);

}  // namespace ashimpact
