// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

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

}  // namespace ashimpact
