// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/quantities/names.hpp"

/// Elastic moduli of a mixture from those of its phases and their volume fractions, which must add up to one.
/// Each rule is a weighted mean: a single phase gives its own modulus.
namespace ashimpact {

/// Bulk and shear modulus of an isotropic solid, in which the rigorous bounds are written.
struct IsotropicModuli {
    double bulk = 0;   ///< K [Pa]
    double shear = 0;  ///< G [Pa]
};

/// Returns K and G from E [Pa] and nu [1]: K = E/(3(1 - 2 nu)), G = E/(2(1 + nu)).
/// Errors: InputError for E <= 0 or nu outside (-1, 0.5); at 0.5 the bulk modulus is infinite.
[[nodiscard]] IsotropicModuli isotropic_moduli(double young_modulus, double poisson_ratio);

/// Returns Young's modulus [Pa]: E = 9KG/(3K + G); it grows with K and with G. Zero if either is zero.
[[nodiscard]] double young_modulus(const IsotropicModuli& moduli);

/// Returns Poisson's ratio [1]: nu = (3K - 2G)/(2(3K + G)). Validity: not both zero, as of a pore.
[[nodiscard]] double poisson_ratio(const IsotropicModuli& moduli);

/// Returns Young's modulus by the parallel model [Pa]: E = sum v_i E_i. Source: Dong et al. 2013, Eq. 1.
/// It is a mean on E, not a bound: Voigt's bound on (K, G) gives a larger E when the Poisson ratios differ.
[[nodiscard]] double parallel_young_modulus(std::span<const double> volume_fractions,
                                            std::span<const double> young_moduli);

/// Returns Young's modulus by the series model (Reuss on E) [Pa]: 1/E = sum v_i/E_i. As 1/E is linear in 1/K
/// and 1/G, this equals E of the Reuss bounds on (K, G) whatever the Poisson ratios.
[[nodiscard]] double series_young_modulus(std::span<const double> volume_fractions,
                                          std::span<const double> young_moduli);

/// Returns the mean of parallel and series (Hill 1952, Proc. Phys. Soc. A 65:349, applied to E) [Pa].
[[nodiscard]] double hill_young_modulus(std::span<const double> volume_fractions,
                                        std::span<const double> young_moduli);

/// Returns Voigt's upper bounds [Pa]: arithmetic means of K and of G. Voigt 1889, as in Hill 1952.
[[nodiscard]] IsotropicModuli voigt_moduli(std::span<const double> volume_fractions,
                                           std::span<const IsotropicModuli> phases);

/// Returns Reuss' lower bounds [Pa]: harmonic means of K and of G. Reuss 1929, as in Hill 1952.
[[nodiscard]] IsotropicModuli reuss_moduli(std::span<const double> volume_fractions,
                                           std::span<const IsotropicModuli> phases);

/// Returns the mean of Voigt's and Reuss' bounds [Pa], the usual estimate for an aggregate.
[[nodiscard]] IsotropicModuli hill_moduli(std::span<const double> volume_fractions,
                                          std::span<const IsotropicModuli> phases);

/// Returns the lower Hashin-Shtrikman bounds [Pa] in Walpole's form, which also holds when the stiffest phase
/// in K is not the stiffest in G:
///   K = [sum v_i/(K_i + y)]^-1 - y,   y = (4/3) G_min,
///   G = [sum v_i/(G_i + z)]^-1 - z,   z = G_min (9 K_min + 8 G_min)/(6 (K_min + 2 G_min)).
/// Phases of zero fraction do not count for the extremes. Source: Hashin & Shtrikman 1963, J. Mech. Phys.
/// Solids 11:127; Walpole 1966, J. Mech. Phys. Solids 14:151. Validity: statistically isotropic and
/// homogeneous mixture.
[[nodiscard]] IsotropicModuli hashin_shtrikman_lower(std::span<const double> volume_fractions,
                                                     std::span<const IsotropicModuli> phases);

/// Returns the upper bounds [Pa]: the same with the largest K and G. Pores may be a phase of K = G = 0.
[[nodiscard]] IsotropicModuli hashin_shtrikman_upper(std::span<const double> volume_fractions,
                                                     std::span<const IsotropicModuli> phases);

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
